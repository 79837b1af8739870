// Use of a plan's queries.
#include "gl/queries.hpp"

namespace passgraph::gl {

bool may_count(const Functions& gl, const Plan& plan)
{
    if (plan.queries.empty())
        return false;
    for (const GLenum target : {GL_SAMPLES_PASSED, GL_ANY_SAMPLES_PASSED, GL_ANY_SAMPLES_PASSED_CONSERVATIVE}) {
        if (target == GL_ANY_SAMPLES_PASSED_CONSERVATIVE && !gl.has_conservative_queries)
            continue;
        GLint running = 0;
        gl.GetQueryiv(target, GL_CURRENT_QUERY, &running);
        if (running != 0)
            return false;
    }
    return true;
}

StepQueries queries_of(const Functions& gl, const PlanObjects& objects, size_t step, const std::vector<bool>& answers, bool counts)
{
    const Plan::Step& row = objects.plan.steps[step];
    const auto id = [&](int query) { return objects.queries[static_cast<size_t>(query)].id(); };
    StepQueries queries;
    if (row.counts >= 0 && counts)
        queries.counts = id(row.counts);
    const bool is_possible = row.when_skipped.empty() || gl.has_inverted_conditions;
    if (row.skipped_by >= 0 && is_possible && answers[static_cast<size_t>(row.skipped_by)])
        queries.skipped_by = id(row.skipped_by);
    return queries;
}

bool counted_nothing(const Functions& gl, GLuint query)
{
    GLuint64 pixels = 0;
    gl.GetQueryObjectui64v(query, GL_QUERY_RESULT, &pixels);
    return pixels == 0;
}

} // namespace passgraph::gl
