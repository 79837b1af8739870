// The contract suite: what every pass, a user's too, is held to.
#pragma once

#include <passgraph/core/pass_library.hpp>
#include <passgraph/gl/renderer.hpp>

#include "tool/contract/report.hpp"
#include "tool/contract/stage.hpp"

namespace passgraph::tool::contract {

/// A pass, what it stands among, the device it is run on, and where faults go.
struct Subject {
    const PassLibrary& library;
    PassPtr pass;
    GlLoader loader;
    Findings& findings;

    const Contract& contract() const { return pass->contract; }
};

/// Runs every check that concerns the pass:
///
///   compiles      its program compiles, also with hostile builtins
///   finite        values of its domain give finite values, before any store's guard
///   range         ... and values inside the contract's range
///   replaced      one bad texel of an input makes nothing that is not finite and in range      (if the contract says so)
///   contained     one bad texel changes no bit further away than the contract says
///   guarded       with guards, a bad texel gives what its replacement gives, and outputs keep to their signals
///   layouts       a geometry pass's outputs keep to their signals under each of its layouts
///   identity      where the header's identity holds, the pass is its input
///   ignores       where an input is ignored, it might as well be black
///   bound         no output is larger than the header says
///   black         an output is 0 where the inputs are that the header says
///   skip          ... and where its condition holds
///   only_where    where a pass with a depth input does nothing, it is the input it names, or 0
///   needs         without the lamps or the sky that it needs, the pass is its identity's input, or 0
///   law_NAME      a law of the contract
///   param_range   parameters are taken up to the ends of their ranges, and refused beyond
///   bound_as_guard  no min, max or clamp stands there for NaN alone, which it does not stop (where no contract is stated)
///
/// Each selection's items, each parameter's ends and the sizes 1x1, 1x9, 9x1 and 17x13 are among the runs.
/// Cost     about a second for a pass of one input on Mesa's softpipe.
PassReport test_pass(const PassLibrary& library, const PassPtr& pass, GlLoader loader);

// The suite's parts, a file each.
void check_values(const Subject& subject);
void check_guards(const Subject& subject);
void check_laws(const Subject& subject);
void check_settings(const Subject& subject);
void check_omissions(const Subject& subject);

/// One settings per item of each selection around the defaults, the defaults first.
std::vector<Settings> selection_variants(const PassDeclaration& pass);
/// The ends of each parameter's range around the defaults, each parameter at another one's default, as smoothstep's edges may
/// meet, then all at their lowest and all at their highest.
std::vector<Settings> parameter_variants(const PassDeclaration& pass);

/// A stage, or nothing and a finding of check `compiles`.
std::optional<Stage> open_stage(const Subject& subject, const StageOptions& options);
/// One draw, or nothing and a finding of check `compiles`.
std::optional<std::map<std::string, Picture>> run_stage(const Subject& subject, Stage& stage, const Feed& feed, const Scene* scene,
                                                        const StageOptions& options);
/// What inputs of signal `color` are fed with in turn; one signal that stands for all where the pass has none.
std::vector<Signal> generic_signals(const PassDeclaration& pass);

/// A setting of every component of a parameter.
PassArguments::Setting number_setting(const Param& param, double value);

/// The value of a header's formula under these settings and inputs' largest components; nothing else is known of inputs, nor of
/// the scene.
double value_of(const Formula& formula, const PassDeclaration& pass, const Settings& settings,
                const std::map<std::string, double, std::less<>>& largest = {});
/// With one input black, or none (`black` is "").
double value_of(const Formula& formula, const PassDeclaration& pass, const Settings& settings, const std::string& black);

} // namespace passgraph::tool::contract
