// From words to ladders.
#include "tool/accuracy/choose.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace passgraph::accuracy {
namespace {

class Choice {
public:
    explicit Choice(const PassLibrary& library) : library_(library)
    {
        for (const Ladder& ladder : all_ladders())
            table_.push_back(std::shared_ptr<const Ladder>(std::shared_ptr<const Ladder>(), &ladder));
    }

    void add_all()
    {
        chosen_ = table_;
        for (const auto& [name, pass] : library_.passes())
            if (pass->family != "probe")
                add_headers(*pass);
    }

    void add_word(const std::string& word)
    {
        const PassPtr pass = library_.find(word);
        const size_t before = chosen_.size();
        bool is_known = false;
        for (const auto& ladder : table_)
            if (ladder->name == word || std::find(ladder->passes.begin(), ladder->passes.end(), word) != ladder->passes.end()) {
                add(ladder);
                is_known = true;
            }
        const size_t failures = errors_.size();
        if (pass)
            add_headers(*pass);
        if (is_known || chosen_.size() > before || errors_.size() > failures)
            return;
        std::vector<std::string> names = library_.names();
        std::vector<std::string> ladders;
        for (const auto& ladder : table_)
            ladders.push_back(ladder->name);
        names.insert(names.end(), ladders.begin(), ladders.end());
        if (pass)
            errors_.push_back({.code = "ladder_missing",
                               .message = fmt::format("`{}` has no ladder, and none of the report concerns it", word),
                               .hint = suggest("", ladders, "ladders")});
        else
            errors_.push_back({.code = "unknown_pass", .message = fmt::format("there is no pass or ladder `{}`", word), .hint = suggest(word, names, "passes and ladders")});
    }

    Result<Ladders> take()
    {
        if (!errors_.empty())
            return tl::unexpected(std::move(errors_));
        return std::move(chosen_);
    }

private:
    void add(const std::shared_ptr<const Ladder>& ladder)
    {
        if (std::none_of(chosen_.begin(), chosen_.end(), [&](const auto& other) { return other->name == ladder->name; }))
            chosen_.push_back(ladder);
    }

    /// The ladders of a header that the table does not measure.
    void add_headers(const PassDeclaration& pass)
    {
        for (const Selection& selection : pass.selections) {
            const std::pair<std::string, std::string> wanted{pass.name, selection.name};
            const bool is_in_table = std::any_of(table_.begin(), table_.end(), [&](const auto& ladder) {
                return std::find(ladder->measures.begin(), ladder->measures.end(), wanted) != ladder->measures.end();
            });
            if (selection.kind != Selection::Kind::ladder || is_in_table)
                continue;
            Result<Ladder> ladder = header_ladder(pass, selection);
            if (ladder)
                add(std::make_shared<const Ladder>(std::move(*ladder)));
            else
                append(errors_, ladder.error());
        }
    }

    const PassLibrary& library_;
    Ladders table_;
    Ladders chosen_;
    Errors errors_;
};

} // namespace

Result<Ladders> choose_ladders(const std::vector<std::string>& words, const PassLibrary& library)
{
    Choice choice(library);
    if (words.empty())
        choice.add_all();
    for (const std::string& word : words)
        choice.add_word(word);
    return choice.take();
}

} // namespace passgraph::accuracy
