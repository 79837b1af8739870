// Comparing texts, and collecting what a pass includes.
#include "passgraph/shader/pass_file_cache.hpp"

#include <algorithm>

#include "passgraph/core/json.hpp"
#include "passgraph/shader/pass_file.hpp"

namespace passgraph {
namespace {

void collect_includes(const GlslText& text, std::vector<std::string>& paths)
{
    for (const auto& included : text.includes) {
        if (std::find(paths.begin(), paths.end(), included->file) != paths.end())
            continue;
        paths.push_back(included->file);
        collect_includes(*included, paths);
    }
}

} // namespace

bool PassFileCache::is_current(const Entry& entry, const std::string& text)
{
    return entry.text == text && std::all_of(entry.includes.begin(), entry.includes.end(), [](const Included& included) {
               const Result<std::string> now = read_text_file(included.path);
               return now && *now == included.text;
           });
}

Result<PassPtr> PassFileCache::load(const std::string& path, const std::string& fallback_common)
{
    Result<std::string> text = read_text_file(path);
    if (!text)
        return tl::unexpected(text.error());
    if (const auto known = entries_.find(path); known != entries_.end() && is_current(known->second, *text))
        return known->second.pass;
    Result<PassPtr> pass = load_pass_file(path, fallback_common);
    if (!pass)
        return pass; // what it included is not known, so it is read again the next time
    Entry entry{std::move(*text), {}, *pass};
    std::vector<std::string> includes;
    collect_includes((*pass)->body, includes);
    for (const std::string& included : includes)
        if (Result<std::string> content = read_text_file(included))
            entry.includes.push_back({included, std::move(*content)});
    entries_.insert_or_assign(path, std::move(entry));
    return pass;
}

} // namespace passgraph
