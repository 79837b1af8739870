// Use of a plan's queries.
#include "gl/queries.hpp"

namespace passgraph::gl {

namespace {

GLuint64 result_of(const Functions& gl, GLuint query)
{
    GLuint64 pixels = 0;
    gl.GetQueryObjectui64v(query, GL_QUERY_RESULT, &pixels);
    return pixels;
}

/// Does not wait: what the device has not done yet is not known.
bool is_known_to_be_none(const Functions& gl, GLuint query)
{
    GLuint64 is_available = GL_FALSE;
    gl.GetQueryObjectui64v(query, GL_QUERY_RESULT_AVAILABLE, &is_available);
    return is_available != GL_FALSE && result_of(gl, query) == 0;
}

} // namespace

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

StepQueries queries_of(const Functions& gl, PlanObjects& objects, size_t step, const std::vector<bool>& answers, bool counts)
{
    const Plan::Step& row = objects.plan.steps[step];
    StepQueries queries;
    if (row.counts >= 0 && counts) {
        CountingQuery& query = objects.queries[static_cast<size_t>(row.counts)];
        queries.counts = query.object.id();
        queries.scouts = query.has_counted && !row.scout.empty() && is_known_to_be_none(gl, queries.counts);
        query.has_counted = true;
    }
    const bool is_possible = row.when_skipped.empty() || gl.has_inverted_conditions;
    if (row.skipped_by >= 0 && is_possible && answers[static_cast<size_t>(row.skipped_by)]) {
        queries.skipped_by = objects.queries[static_cast<size_t>(row.skipped_by)].object.id();
        queries.is_known_black = is_known_to_be_none(gl, queries.skipped_by);
    }
    return queries;
}

bool was_skipped(const Functions& gl, const StepQueries& queries)
{
    const GLuint asked = queries.scouts ? queries.counts : queries.skipped_by;
    return asked != 0 && result_of(gl, asked) == 0;
}

} // namespace passgraph::gl
