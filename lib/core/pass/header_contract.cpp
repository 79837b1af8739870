// Reads a pass's contract, and refuses one that its own signals contradict.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/pass/header_fields.hpp"

namespace passgraph {
namespace {

struct LawRow {
    Law law;
    std::string_view name;
    std::string_view meaning;
};

constexpr std::array<LawRow, kLawCount> kLaws = {{
    {Law::constant, "constant", "equal light in every texel comes back as it is"},
    {Law::black, "black", "no light in, exactly none out"},
    {Law::energy, "energy", "no light output exceeds the one light that comes in"},
    {Law::monotone, "monotone", "more light in, nowhere less out"},
    {Law::mirror, "mirror", "mirrored inputs give mirrored outputs"},
    {Law::scale, "scale", "twice the light in, exactly twice out"},
}};

bool is_light(Signal signal) { return info(signal).is_generic_color || signal == Signal::color; }

} // namespace

std::string_view name(Law law) { return kLaws[static_cast<size_t>(law)].name; }
std::string_view meaning(Law law) { return kLaws[static_cast<size_t>(law)].meaning; }

namespace header {
namespace {

class ContractReader {
public:
    ContractReader(const Json& json, PassDeclaration& pass, Errors& errors)
        : json_(json), pass_(pass), errors_(errors), contract_(pass.contract)
    {
    }

    void run()
    {
        contract_.is_stated = true;
        contract_.where = json_.where;
        JsonFields fields(json_, "\"contract\"", errors_);
        if (const Json* domain = fields.find("domain", Json::Kind::object))
            read_spans(*domain, pass_.inputs, "input", contract_.domain, false);
        if (const Json* range = fields.find("range", Json::Kind::object))
            read_spans(*range, pass_.outputs, "output", contract_.range, true);
        if (const Json* non_finite = fields.require("non_finite"))
            read_non_finite(*non_finite);
        if (const Json* laws = fields.find("laws", Json::Kind::array))
            for (const Json& law : laws->array)
                read_law(law);
        fields.finish();
    }

private:
    void contradict(std::string message, std::string hint, const Location& where)
    {
        errors_.push_back({"contract_contradicts_signal", std::move(message), std::move(hint), where});
    }

    template <class Ports>
    void read_spans(const Json& spans, const Ports& ports, std::string_view what, std::vector<Contract::Span>& into,
                    bool is_range)
    {
        for (const Json::Member& member : spans.members) {
            const auto port = std::find_if(ports.begin(), ports.end(), [&](const auto& p) { return p.name == member.key; });
            if (port != ports.end()) {
                read_span(member, port->signal, into, is_range);
                continue;
            }
            report_unknown(member.key, ports, what, member.where);
        }
    }

    template <class Ports>
    void report_unknown(const std::string& name, const Ports& ports, std::string_view what, const Location& where)
    {
        std::vector<std::string> names;
        for (const auto& port : ports)
            names.push_back(port.name);
        errors_.push_back({fmt::format("unknown_{}", what), fmt::format("there is no {} `{}`", what, name),
                           suggest(name, names, fmt::format("{}s", what)), where});
    }

    void read_span(const Json::Member& member, Signal signal, std::vector<Contract::Span>& into, bool is_range)
    {
        const Json& value = member.value;
        const bool is_pair = value.is(Json::Kind::array) && value.array.size() == 2;
        const bool is_saturated = is_pair && is_range && value.array[1].string == "saturated";
        if (!is_pair || !value.array[0].is(Json::Kind::number) ||
            (!is_saturated && !value.array[1].is(Json::Kind::number))) {
            report_wrong_type(value, fmt::format("`{}`", member.key),
                              is_range ? "two numbers, the second of which may be \"saturated\"" : "two numbers", errors_);
            return;
        }
        const Domain domain = domain_of(signal);
        Contract::Span span{member.key, value.array[0].number, is_saturated ? domain.highest : value.array[1].number,
                            is_saturated, member.where};
        const std::string_view of = info(signal).name;
        if (!(span.lowest <= span.highest))
            contradict(fmt::format("`{}`: no value lies in [{}, {}]", member.key, span.lowest, span.highest),
                       "the lowest value comes first", value.where);
        else if (span.lowest < domain.lowest || span.highest > domain.highest)
            contradict(fmt::format("`{}`: [{}, {}] leaves the domain [{}, {}] of {}", member.key, span.lowest, span.highest,
                                   domain.lowest, domain.highest, of),
                       is_range ? "keep the output inside, or choose another signal for it"
                                : "an input never holds such values: state a part of its signal's domain",
                       value.where);
        else if (is_saturated && signal != Signal::radiance && signal != Signal::radiance_alpha && signal != Signal::color)
            contradict(fmt::format("`{}`: {} ends at {}, and a larger value is no light that is cut off", member.key, of,
                                   domain.highest),
                       fmt::format("write [{}, {}]", span.lowest, domain.highest), value.where);
        into.push_back(std::move(span));
    }

    void read_non_finite(const Json& json)
    {
        if (json.is(Json::Kind::string) && json.string == "replaced") {
            contract_.non_finite = Contract::NonFinite::replaced;
            return;
        }
        if (json.is(Json::Kind::string) && json.string == "contained")
            return;
        if (!json.is(Json::Kind::object)) {
            report_wrong_type(json, "\"non_finite\"", "\"replaced\", \"contained\" or { \"contained\": texels }", errors_);
            return;
        }
        JsonFields fields(json, "\"non_finite\"", errors_);
        if (const Json* within = fields.require("contained")) {
            if (within->is(Json::Kind::number) && within->number >= 0.0)
                contract_.within = *Formula::parse(fmt::format("{}", within->number), within->where);
            else if (within->is(Json::Kind::string))
                contract_.within = read_formula(*within, formula_names(pass_), "parameters and choices", errors_);
            else
                report_wrong_type(*within, "\"contained\"", "a number of texels, or an expression of parameters", errors_);
        }
        if (const Json* anywhere = fields.find("anywhere", Json::Kind::array))
            for (const Json& input : anywhere->array) {
                if (pass_.find_input(input.string) < 0)
                    report_unknown(input.string, pass_.inputs, "input", input.where);
                contract_.anywhere.push_back(input.string);
            }
        fields.finish();
    }

    void read_law(const Json& json)
    {
        const auto row = std::find_if(kLaws.begin(), kLaws.end(), [&](const LawRow& r) { return r.name == json.string; });
        if (row == kLaws.end()) {
            std::vector<std::string> names;
            for (const LawRow& known : kLaws)
                names.emplace_back(known.name);
            errors_.push_back({"unknown_law", fmt::format("there is no law `{}`", json.string),
                               suggest(json.string, names, "laws"), json.where});
            return;
        }
        contract_.laws.push_back(row->law);
        if (row->law == Law::mirror)
            return;
        const auto has_light = [](const auto& ports) {
            return std::any_of(ports.begin(), ports.end(), [](const auto& port) { return is_light(port.signal); });
        };
        if (!has_light(pass_.inputs) || !has_light(pass_.outputs))
            contradict(fmt::format("law `{}` is about light, and no {} of the pass holds any", row->name,
                                   has_light(pass_.inputs) ? "output" : "input"),
                       "leave the law out", json.where);
    }

    const Json& json_;
    PassDeclaration& pass_;
    Errors& errors_;
    Contract& contract_;
};

} // namespace

void read_contract(const Json& contract, PassDeclaration& pass, Errors& errors) { ContractReader(contract, pass, errors).run(); }

} // namespace header
} // namespace passgraph
