// Reads a pass file's text: header, includes, names.
#include "passgraph/core/pass_header.hpp"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "core/pass/glsl_scan.hpp"
#include "core/pass/header_fields.hpp"

namespace passgraph {
namespace {

/// Resolves `#include "name"` lines; a file included twice is one GlslText.
class Includes {
public:
    Includes(const IncludeFinder& find, Errors& errors) : find_(find), errors_(errors) {}

    /// Blanks the include lines of `text` and appends what they name to `into`.
    std::string resolve(std::string_view text, const Location& start,
                        std::vector<std::shared_ptr<const GlslText>>& into)
    {
        std::string rest(text);
        for (const GlslToken& token : scan_glsl(text, start.line, start.column)) {
            if (!token.is_directive || !token.text.starts_with("#include"))
                continue;
            const Location where{start.file, token.line, token.column};
            const size_t offset = static_cast<size_t>(token.text.data() - text.data());
            std::fill_n(rest.begin() + static_cast<std::ptrdiff_t>(offset), token.text.size(), ' ');
            const size_t open = token.text.find('"');
            const size_t close = token.text.rfind('"');
            if (open == std::string_view::npos || close == open) {
                errors_.push_back(
                    {"include_missing", "an include names its file in quotes", "#include \"luminance.glsl\"", where});
                continue;
            }
            if (auto included = load(token.text.substr(open + 1, close - open - 1), where))
                into.push_back(std::move(included));
        }
        return rest;
    }

private:
    std::shared_ptr<const GlslText> load(std::string_view name, const Location& where)
    {
        if (name.find("..") != std::string_view::npos || name.starts_with('/')) {
            errors_.push_back({"include_missing", fmt::format("`{}` is outside the common folder", name),
                               "name a file in common/", where});
            return nullptr;
        }
        const auto found = find_(name);
        if (!found) {
            errors_.push_back({"include_missing", fmt::format("there is no common file `{}`", name),
                               "put it into common/ beside the pass", where});
            return nullptr;
        }
        if (std::find(open_.begin(), open_.end(), found->path) != open_.end()) {
            errors_.push_back({"include_cycle", fmt::format("`{}` includes itself", name), "cut the circle", where});
            return nullptr;
        }
        if (const auto known = known_.find(found->path); known != known_.end())
            return known->second;
        open_.push_back(found->path);
        auto text = std::make_shared<GlslText>();
        text->file = found->path;
        text->text = resolve(found->text, {found->path, 1, 1}, text->includes);
        const auto tokens = scan_glsl(text->text, 1, 1);
        text->globals = global_names(tokens);
        text->macros = macro_names(tokens);
        report_forbidden(tokens, text->file, false, errors_);
        open_.pop_back();
        known_[found->path] = text;
        return text;
    }

    const IncludeFinder& find_;
    Errors& errors_;
    std::map<std::string, std::shared_ptr<const GlslText>> known_;
    std::vector<std::string> open_;
};

void read_reads(const Json& reads, PassDeclaration& pass, Errors& errors)
{
    std::vector<std::string> names;
    for (const ReadRow& row : kReads)
        names.emplace_back(row.name);
    for (const Json& item : reads.array) {
        const auto row = std::find_if(kReads.begin(), kReads.end(), [&](const ReadRow& known) { return known.name == item.string; });
        if (row != kReads.end())
            pass.reads.*row->member = true;
        else
            errors.push_back({"unknown_item", fmt::format("a pass cannot read `{}`", item.string),
                              suggest(item.string, names, "things to read"), item.where});
    }
}

/// "depth", or { "no_depth": INPUT }.
void read_only_where(const Json& where, PassDeclaration& pass, Errors& errors)
{
    if (pass.kind == PassKind::geometry)
        errors.push_back({"only_where_geometry", "a geometry pass draws where its triangles are",
                          "remove \"only_where\"", where.where});
    if (where.is(Json::Kind::object)) {
        JsonFields fields(where, "\"only_where\"", errors);
        if (const Json* elsewhere = fields.require("no_depth", Json::Kind::string)) {
            pass.only_where = OnlyWhere::no_depth;
            pass.elsewhere = elsewhere->string;
            header::check_is_input(*elsewhere, pass, errors);
        }
        fields.finish();
        return;
    }
    pass.only_where = OnlyWhere::depth;
    if (where.string != "depth")
        errors.push_back({"unknown_item", "\"only_where\" is \"depth\" or { \"no_depth\": INPUT }",
                          "with INPUT what the pass is where there is depth", where.where});
}

/// Ports, parameters, choices and ladders share one namespace with what is generated for them.
void check_namespace(const PassDeclaration& pass, Errors& errors)
{
    std::map<std::string, Location> taken;
    const auto take = [&](const std::string& name, const Location& where) {
        const auto [entry, is_new] = taken.emplace(name, where);
        if (!is_new)
            errors.push_back(
                {"duplicate_name", fmt::format("`{}` is used twice", name),
                 fmt::format("ports, parameters, choices and ladders share one namespace; line {} has it too",
                             entry->second.line),
                 where});
    };
    take(pass.name, {pass.file, 1, 1});
    for (const InputPort& port : pass.inputs) {
        if (port.over == Over::sphere && port.name == pass.name)
            continue; // sky(direction, lod) beside sky(uv): GLSL overloads
        take(port.name, port.where);
        if (port.over == Over::sphere)
            take(port.name + "_top_lod", port.where);
        if (port.over == Over::sphere && port.has_levels)
            take(port.name + "_irradiance", port.where);
        if (port.over == Over::sphere || port.over == Over::scene)
            continue;
        take(port.name + "_texel", port.where);
        take(port.name + "_size", port.where);
        if (port.signal == Signal::color)
            take(port.name + "_alpha", port.where);
        if (port.has_levels)
            take(port.name + "_lod", port.where);
    }
    for (const Param& param : pass.params)
        take(param.name, param.where);
    for (const Selection& selection : pass.selections)
        if (selection.kind != Selection::Kind::layout)
            take(selection.name, selection.where);
    for (const OutputPort& port : pass.outputs)
        if (taken.contains(port.name))
            errors.push_back({"duplicate_name", fmt::format("`{}` is used twice", port.name),
                              "ports, parameters, choices and ladders share one namespace", port.where});
}

void read_fields(const Json& root, PassDeclaration& pass, Errors& errors)
{
    JsonFields fields(root, "pass header", errors);
    if (const Json* name = fields.require("pass", Json::Kind::string)) {
        pass.name = name->string;
        header::check_name(name->string, "a pass", name->where, errors);
    }
    pass.summary = fields.text("summary");
    pass.source = fields.text("source");
    const std::string kind = fields.text("kind", "image");
    if (kind == "geometry") {
        pass.kind = PassKind::geometry;
        InputPort scene;
        scene.name = "scene";
        scene.over = Over::scene;
        scene.access = {AccessClass::pointwise, 0};
        scene.where = root.where;
        pass.inputs.push_back(std::move(scene));
    } else if (kind != "image") {
        errors.push_back({"unknown_item", fmt::format("a pass cannot be of kind `{}`", kind),
                          suggest(kind, {"image", "geometry"}, "kinds"), root.find("kind")->where});
    }
    if (const Json* inputs = fields.find("inputs", Json::Kind::object))
        header::read_inputs(*inputs, pass, errors);
    if (const Json* outputs = fields.require("outputs", Json::Kind::object)) {
        header::read_outputs(*outputs, pass, errors);
        if (outputs->members.empty())
            errors.push_back({"field_missing", "a pass has at least one output", "", outputs->where});
    }
    if (const Json* params = fields.find("params", Json::Kind::object))
        header::read_params(*params, pass, errors);
    if (const Json* choices = fields.find("choices", Json::Kind::object))
        header::read_selections(*choices, Selection::Kind::choice, pass, errors);
    if (const Json* ladders = fields.find("ladders", Json::Kind::object))
        header::read_selections(*ladders, Selection::Kind::ladder, pass, errors);
    if (const Json* layouts = fields.find("layouts", Json::Kind::object))
        header::read_layouts(*layouts, pass, errors);
    header::check_filters(pass, errors);
    for (const Param& param : pass.params)
        if (param.visible_if)
            header::check_names(*param.visible_if, formula_names(pass), "parameters and choices", errors);
    if (const Json* reads = fields.find("reads", Json::Kind::array))
        read_reads(*reads, pass, errors);
    if (const Json* identity = fields.find("identity"))
        header::read_identity(*identity, pass, errors);
    if (const Json* needs = fields.find("needs"))
        header::read_needs(*needs, pass, errors);
    if (const Json* bounds = fields.find("bound"))
        header::read_bounds(*bounds, pass, errors);
    if (const Json* ignores = fields.find("ignores", Json::Kind::object))
        header::read_ignores(*ignores, pass, errors);
    if (const Json* contract = fields.find("contract", Json::Kind::object))
        header::read_contract(*contract, pass, errors);
    if (const Json* where = fields.find("only_where"))
        read_only_where(*where, pass, errors);
    if (const Json* black = fields.find("black"))
        header::read_black(*black, pass, errors);
    if (const Json* skip = fields.find("skip", Json::Kind::object))
        header::read_skip(*skip, pass, errors);
    fields.finish();
}

void check_helpers(const PassDeclaration& pass, const std::vector<GlslToken>& tokens, Errors& errors)
{
    for (const std::string& global : pass.body.globals) {
        const auto token =
            std::find_if(tokens.begin(), tokens.end(), [&](const GlslToken& t) { return t.text == global; });
        const Location where{pass.file, token == tokens.end() ? 0 : token->line,
                             token == tokens.end() ? 0 : token->column};
        if (global != pass.name)
            header::check_name(global, "a helper", where, errors);
    }
}

} // namespace

Result<PassDeclaration> read_pass_header(std::string_view text, const std::string& file, const std::string& family,
                                         const IncludeFinder& find_include)
{
    const size_t open = text.find("/*");
    const size_t close = open == std::string_view::npos ? open : text.find("*/", open + 2);
    const bool leads =
        open != std::string_view::npos && text.substr(0, open).find_first_not_of(" \t\r\n") == std::string_view::npos;
    if (!leads || close == std::string_view::npos)
        return fail({"header_missing",
                     "the file does not start with its header, a JSON object in a comment",
                     "start it with /*{ \"pass\": \"name\", \"inputs\": {…}, \"outputs\": {…} }*/",
                     {file, 1, 1}});
    const auto line_of = [&](size_t at) {
        return 1 + static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
    };
    const auto column_of = [&](size_t at) {
        return static_cast<int>(at - (text.rfind('\n', at) == std::string_view::npos ? 0 : text.rfind('\n', at) + 1)) +
               1;
    };
    const auto json = parse_json(text.substr(open + 2, close - open - 2), file, line_of(open), column_of(open + 2));
    if (!json)
        return tl::unexpected(json.error());

    Errors errors;
    PassDeclaration pass;
    pass.file = file;
    pass.family = family;
    read_fields(*json, pass, errors);
    check_namespace(pass, errors);

    pass.body.file = file;
    pass.body.first_line = line_of(close);
    const std::string_view body = text.substr(close + 2);
    pass.body.text = Includes(find_include, errors)
                         .resolve(body, {file, pass.body.first_line, column_of(close + 2)}, pass.body.includes);
    const auto tokens = scan_glsl(pass.body.text, pass.body.first_line, column_of(close + 2));
    pass.body.globals = global_names(tokens);
    pass.body.macros = macro_names(tokens);
    check_helpers(pass, tokens, errors);
    report_forbidden(tokens, file, pass.kind == PassKind::geometry, errors);
    if (!errors.empty())
        return tl::unexpected(std::move(errors));
    return pass;
}

} // namespace passgraph
