// The pool's keys and its bound.
#include "gl/program_pool.hpp"

namespace passgraph::gl {

std::string ProgramPool::key_of(const Plan::Step& step)
{
    std::string key = step.vertex + '\0' + step.fragment;
    for (const Plan::Read& read : step.reads)
        key += '\0' + read.sampler;
    for (const Plan::Uniform& uniform : step.uniforms)
        key += '\0' + uniform.name;
    return key;
}

std::shared_ptr<LinkedProgram> ProgramPool::find(const std::string& key)
{
    const auto entry = std::find_if(entries_.begin(), entries_.end(), [&](const Entry& known) { return known.key == key; });
    if (entry == entries_.end())
        return nullptr;
    entries_.splice(entries_.begin(), entries_, entry);
    return entry->program;
}

void ProgramPool::add(std::string key, std::shared_ptr<LinkedProgram> program)
{
    entries_.push_front({std::move(key), std::move(program)});
    if (entries_.size() > kMostPrograms)
        entries_.pop_back();
}

} // namespace passgraph::gl
