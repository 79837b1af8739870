// The user interface over the picture.
#pragma once

#include "tool/view/inspector.hpp"
#include "tool/view/stage.hpp"
#include "tool/view/view_state.hpp"

namespace passgraph::tool::view {

/// Pixels of the window, and the clock.
struct Surface {
    int width = 0;
    int height = 0;
    double now = 0.0; ///< seconds

    /// Of what the panel leaves free.
    float free_width(const ViewState& state) const;
};

/// Draws everything that is open; returns what a person asked for.
PanelOrders draw_interface(ViewState& state, const Stage& stage, const Inspector& inspector, const Surface& surface);

// Its parts, a file each.
void draw_settings(ViewState& state, PanelOrders& orders);                                          // panel_settings.cpp
void draw_images(ViewState& state, const Inspector& inspector, PanelOrders& orders);                // panel_images.cpp
void draw_costs(const Stage& stage);                                                                // panel_plan.cpp
void draw_plan(const Stage& stage);                                                                 // panel_plan.cpp
void draw_help(const ViewState& state, const Surface& surface);                                     // overlay.cpp
void draw_mistakes(const ViewState& state, const Surface& surface);                                 // overlay.cpp
void draw_start(const Stage& stage, const Surface& surface);                                        // overlay.cpp
void draw_notice(const ViewState& state, const Surface& surface);                                   // overlay.cpp
void draw_answer(ViewState& state, const Inspector& inspector, const Surface& surface, PanelOrders& orders); // overlay.cpp
/// The font of columns while it lives.
struct MonoFont {
    MonoFont();
    ~MonoFont();
    MonoFont(const MonoFont&) = delete;
    MonoFont& operator=(const MonoFont&) = delete;
};

} // namespace passgraph::tool::view
