// The part of JSON Schema that the repository's schemas use.
#pragma once

#include <string>
#include <vector>

#include <passgraph/core/json.hpp>

namespace passgraph::test {

/// Every place where the value is not as the schema says: "steps[0].ms: expected number". Empty: it is valid.
///
/// Knows type, const, enum, required, properties, additionalProperties, items, minItems, maxItems, minimum, maximum, oneOf
/// and `$ref` into `$defs`; any other keyword but title, description, $schema and $defs is a finding of its own.
std::vector<std::string> find_schema_violations(const Json& value, const Json& schema);

/// A schema of the repository, by its path there.
Json read_schema(const std::string& path);

} // namespace passgraph::test
