// The window's life: events in, files watched, plans made, frames drawn.
#pragma once

#include <chrono>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <passgraph/context/window.hpp>

#include "tool/view/camera_controller.hpp"
#include "tool/view/file_watch.hpp"
#include "tool/view/inspector.hpp"
#include "tool/view/key_map.hpp"
#include "tool/view/loader.hpp"
#include "tool/view/panel.hpp"
#include "tool/view/stage.hpp"
#include "tool/view/view_state.hpp"

namespace passgraph::tool::view {

struct ViewOptions {
    std::vector<std::string> graphs;
    std::string scene;
    std::string preset;
    std::vector<std::string> pass_folders; ///< watched; later ones replace passes of earlier ones
    std::string size;                      ///< of the window
    std::string pictures = ".";            ///< the folder P saves to
    double render_scale = 1.0;             ///< of the window's extent
    bool hides_panel = false;
    CompileOptions compiler{};             ///< which steps to leave out
};

/// What a start needs, read and found to be without mistakes.
struct Opening {
    std::unique_ptr<Loader> loader;
    std::vector<Stack> stacks;
    std::shared_ptr<const PassLibrary> library;
    std::shared_ptr<const Scene> scene;
    Errors pass_errors; ///< of passes that no graph needed
};

/// Reads everything and compiles every graph.
/// Errors   those of the graphs, the scene and the preset; scene_missing.
Result<Opening> open_files(const ViewOptions& options);

/// Everything whose change matters to the window.
WatchedPaths watched_paths(const ViewOptions& options);

/// The window until it is closed. Mistakes made meanwhile are shown in it and on stderr.
class Session {
public:
    Session(const ViewOptions& options, Opening opening, std::unique_ptr<Window> window, Stage stage, const Device& device);
    ~Session();
    void run();

private:
    // session.cpp: the loop
    void take_events(const std::vector<WindowEvent>& events);
    void take_left_button(const WindowEvent& event);
    void move_camera(double seconds);
    void draw_frame();
    void ask_at(double x, double y);
    void reset_camera();
    void present();
    double seconds_to_wait() const;
    double now() const;
    Extent wanted_extent() const;
    CompileOptions compile_options() const;
    Frame frame() const;
    Inspected inspected(const Camera* camera, const CompileOptions& options) const;

    // session_orders.cpp: what people ask for
    void obey(const Order& order);
    void obey(const PanelOrders& orders);
    void pick_stack(size_t index);
    void show_image(int index);
    void save_picture();
    void save_preset();
    void save_graph();
    void take_saved();
    void keep_saving_errors(Errors errors);
    void say(std::string notice);

    // session_files.cpp: what changes under the window
    void watch_files();
    void take_loaded();
    void take_scene(LoadedScene loaded);
    void take_scene_images();
    void show_coming_scene();
    /// The first scene is not on the device yet: nothing can be drawn.
    bool is_awaiting_scene() const { return coming_scene_ && !scene_; }
    void keep_scene_errors(Errors errors);
    void refresh_controls();
    void plan_again();
    void work_on_plans();
    void tell(const Errors& before, const Errors& after) const;
    void tell_how_long();
    void print_answer() const;

    const ViewOptions options_;
    const Device device_;
    std::unique_ptr<Window> window_; ///< before all that its context holds
    std::shared_ptr<const Scene> scene_;
    Stage stage_;
    Inspector inspector_;
    std::unique_ptr<Loader> loader_;
    FileWatch watch_;
    ViewState state_;
    HeldKeys keys_;
    std::optional<CameraController> flight_;
    double speed_ = 1.0; ///< of the flight, m/s
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();

    bool is_ended_ = false;
    bool needs_plan_ = true;
    bool needs_frame_ = true;
    int presents_ = 3; ///< the user interface settles within that many
    int frames_ = 0;
    double last_look_ = 0.0;    ///< at the files
    double last_step_ = 0.0;    ///< of the camera
    double last_change_ = 0.0;  ///< of what the frame shows
    double resized_at_ = 0.0;
    double drawn_time_ = 0.0;
    Extent window_extent_{};    ///< at the last look
    Extent planned_extent_{};
    bool is_dragging_ = false;
    bool has_dragged_ = false; ///< the button went a way: no click
    double drag_x_ = 0.0, drag_y_ = 0.0, press_x_ = 0.0, press_y_ = 0.0;

    /// A change of files on its way to the eye.
    struct Change {
        std::string what;
        std::filesystem::file_time_type saved;
    };
    std::optional<Change> change_;
    std::future<Result<std::string>> saving_;
    /// A scene that was read and is on its way to the device.
    std::shared_ptr<const Scene> coming_scene_;
    std::future<Result<SceneImages>> scene_images_;
    std::optional<SceneImages> coming_images_; ///< waits for a plan that is right for it
    Facts facts_; ///< that plans are made for
};

} // namespace passgraph::tool::view
