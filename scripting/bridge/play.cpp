// The two loops around a game: with a window and real time, and headless. Both feed it the same way: whatever
// enters the game is a list of events per update, taken from the platform or from a recording, and noted down
// when asked for.
#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <cairn/engine/fixed_step.h>
#include <cairn/engine/image.h>
#include <cairn/engine/native_file.h>
#include <cairn/engine/printable.h>
#include <cairn/engine/video.h>
#include <cairn/scripting/play.h>

#include "bridge/error_screen.h"
#include "bridge/game.h"
#include "bridge/hot_reload.h"
#include "bridge/machine.h"
#include "bridge/replay.h"
#include "debug/developer_tools.h"
#include "lua/interruption.h"

namespace cairn::scripting {
namespace {

using engine::InputEvent;
using engine::InputKind;
using Outcome = std::optional<ScriptError>;

/// As many updates as FixedStep's own limit takes of 1/60 s, in the time of others.
int most_updates_at_once(int updates_per_second) {
    return (engine::FixedStep::kDefaultMaxUpdates * updates_per_second + 59) / 60;
}

int fail(const std::string& message) {
    std::fprintf(stderr, "cairn: error: %s\n", engine::printable(message).c_str());
    return 1;
}

engine::Result<Replay> read_replay(const std::string& path) {
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored))
        return engine::Error{"cannot read the recording \"" + path + "\": it is a folder"};
    std::ifstream file(path, std::ios::binary);
    if (!file) return engine::Error{"cannot read the recording \"" + path + "\": " + std::strerror(errno)};
    std::ostringstream text;
    text << file.rdbuf();
    return parse_replay(text.str(), path);
}

/// The clock is asked once, for the seed of a new game.
std::uint64_t seed_by_clock() {
    return static_cast<std::uint64_t>(std::chrono::system_clock::now().time_since_epoch().count());
}

class Session {
  public:
    Session(const PlayOptions& options, Machine& machine, std::optional<Replay> replay)
        : options_(options), machine_(machine), replay_(std::move(replay)) {
        seed_ = replay_ ? replay_->seed : options.seed.value_or(options.headless ? 1 : seed_by_clock());
        last_frame_ = options.frames;
        if (replay_) last_frame_ = std::min(options.frames.value_or(replay_->frames), replay_->frames);
        if (options.headless && !last_frame_) last_frame_ = kDefaultHeadlessFrames;
        if (!options.headless && !replay_ && options.record.empty())
            reload_.emplace(options.source, machine, options.arguments);
    }

    int run() {
        const int status = run_to_end();
        const int signal = machine_.platform->end_signal();
        return signal != 0 ? kSignalStatus + signal : status;
    }

  private:
    int run_to_end() {
        for (const std::string& tool : options_.shown_tools) {
            if (auto shown = tools_.show(tool); !shown) return fail(shown.error().message);
        }
        if (options_.print_timings) tools_.measure();
        machine_.platform->on_end_signal(Interruption::request);
        Outcome error = start();
        if (options_.headless) {
            if (!error && !options_.video.empty()) error = start_video();
            if (!error) error = run_headless();
            if (error) {
                report(*error);
                return finish_with_error();
            }
        } else if (!run_in_window(std::move(error))) {
            return finish_with_error();
        }
        return finish();
    }

    /// Whether the run must not depend on what the player has saved, nor leave anything: a recording would
    /// not know of it.
    bool is_repeatable() const { return options_.headless || replay_ || !options_.record.empty(); }

    Outcome start() {
        tools_.forget_game();
        tools_.set_can_change(options_.record.empty() && !replay_);
        keeps_game_ = false;
        if (reload_) reload_->forget();
        machine_.reset_window();
        interruption_.watch(nullptr);
        game_ = std::make_unique<Game>(machine_.services(),
                                       GameOptions{.seed = seed_,
                                                   .visual_seed = options_.headless ? 1 : seed_by_clock(),
                                                   .plays_saves = is_repeatable()});
        interruption_.watch(game_->lua());
        recorded_.clear();
        next_event_ = 0;
        Outcome error = game_->load(machine_.main_path, options_.arguments);
        is_loaded_ = !error;
        return error;
    }

    /// One update, with events from the recording or those given.
    Outcome update(std::vector<InputEvent>& events) {
        if (replay_) {
            events.clear();
            const auto& recorded = replay_->events;
            for (; next_event_ < recorded.size() && recorded[next_event_].frame <= game_->frame() + 1;
                 ++next_event_) {
                events.push_back(recorded[next_event_].event);
            }
        } else if (game_->frame() == 0) {
            tell_window_size(events);
        }
        for (const InputEvent& event : events) recorded_.push_back({game_->frame() + 1, event});
        const FrameMeter::Scope scope(tools_.meter(), FramePart::Update);
        Outcome error = game_->update(events);
        events.clear();
        return error;
    }

    /// A window may have another size than conf.lua asked for from the start, as on a full screen.
    void tell_window_size(std::vector<InputEvent>& events) const {
        const engine::Size size = machine_.platform->window().size();
        if (machine_.conf.scaling != engine::WindowScaling::Follow || size == machine_.conf.size) return;
        InputEvent event{.kind = InputKind::WindowResized};
        event.delta = {static_cast<float>(size.width), static_cast<float>(size.height)};
        events.insert(events.begin(), event);
    }

    bool is_over() const { return game_->wants_quit() || (last_frame_ && game_->frame() >= *last_frame_); }

    /// Draws and, when it is due, writes the picture to its file.
    Outcome draw(double alpha, bool captures) {
        engine::Renderer& renderer = *machine_.renderer;
        renderer.begin_frame(machine_.conf.background);
        Outcome error;
        {
            const FrameMeter::Scope scope(tools_.meter(), FramePart::Draw);
            error = game_->draw(alpha);
        }
        if (!error) tools_.draw(*game_);
        if (!error && video_ && filmed_frame_ < game_->frame()) error = film();
        if (!error && captures) error = write_screenshot();
        {
            const FrameMeter::Scope scope(tools_.meter(), FramePart::Present);
            renderer.end_frame();
        }
        tools_.end_frame(*game_);
        return error;
    }

    Outcome start_video() {
        // A picture for each update.
        auto video = engine::VideoWriter::create(options_.video, machine_.platform->window().size(),
                                                 machine_.conf.updates_per_second);
        if (!video) return ScriptError{video.error().message, {}};
        video_ = *std::move(video);
        return std::nullopt;
    }

    Outcome film() {
        filmed_frame_ = game_->frame();
        const auto image = machine_.renderer->capture();
        if (!image) return ScriptError{image.error().message, {}};
        if (const auto written = video_->write(*image); !written)
            return ScriptError{written.error().message, {}};
        return std::nullopt;
    }

    Outcome write_screenshot() {
        is_captured_ = true;
        const auto image = machine_.renderer->capture();
        if (!image) return ScriptError{image.error().message, {}};
        if (auto saved = engine::save_png(*image, options_.screenshot); !saved)
            return ScriptError{saved.error().message, {}};
        return std::nullopt;
    }

    bool captures_now() const {
        return !options_.screenshot.empty() && !is_captured_ && options_.screenshot_frame == game_->frame();
    }
    bool captures_at_end() const {
        return !options_.screenshot.empty() && !is_captured_ && !options_.screenshot_frame;
    }

    Outcome run_headless() {
        // Pictures cost time and decide nothing, but a draw callback that fails must not go unnoticed: once a
        // second of game time is enough for that.
        const auto frames_per_picture = static_cast<std::uint64_t>(machine_.conf.updates_per_second);
        std::vector<InputEvent> events;
        while (!is_over()) {
            machine_.platform->poll_events(events);
            if (Outcome error = update(events)) return error;
            const bool captures = captures_now();
            const bool is_sample = options_.screenshot.empty() && game_->frame() % frames_per_picture == 1;
            if (captures || is_sample || video_ || tools_.needs_every_picture()) {
                if (Outcome error = draw(1, captures)) return error;
            } else {
                tools_.end_frame(*game_);
            }
        }
        return captures_at_end() ? draw(1, true) : std::nullopt;
    }

    /// False when the session ends with an error that nobody could mend.
    bool run_in_window(Outcome error) {
        engine::Platform& platform = *machine_.platform;
        engine::FixedStep step(1.0 / machine_.conf.updates_per_second,
                               most_updates_at_once(machine_.conf.updates_per_second));
        std::vector<InputEvent> waiting;
        double then = platform.now_s();
        double picture_due_s = then;
        while (true) {
            if (error) {
                report(*error);
                // A run of fixed length is a test: there is nobody to press a key.
                if (last_frame_ || !wait_at_error_screen(*error)) return false;
                error = has_changes() && can_go_on() ? go_on() : start();
                waiting.clear();
                step.reset();
                then = platform.now_s();
                continue;
            }
            if (has_changes()) {
                error = take_in_changes();
                if (error) continue;
            }
            platform.poll_events(waiting);
            if (machine_.conf.has_developer_keys) tools_.take_keys(waiting);
            tools_.take_input(waiting, *game_);
            if (platform.end_signal() != 0) return end_in_good_order(waiting);
            if (wants_restart()) {
                error = start();
                waiting.clear();
                step.reset();
                continue;
            }
            if (replay_ && asks_to_quit(waiting)) return true;
            const double now = platform.now_s();
            engine::FixedStep::Frame frame = step.advance(tools_.time().game_time_s(now - then));
            then = now;
            if (tools_.time().goes_back()) {
                for (; frame.updates > 0 && !error; --frame.updates) error = tools_.step_back(*game_);
                frame.alpha = 1;
                if (error) continue;
            }
            if (tools_.time().is_paused()) frame = {.updates = tools_.time().take_steps(), .alpha = 1};
            // A late picture has several updates; the one of the screenshot must not fall between two
            // pictures.
            for (int i = 0; i < frame.updates && !error && !is_over() && !captures_now(); ++i) {
                error = update(waiting);
                if (!error) error = tools_.note_update(*game_);
            }
            if (error) continue;
            const bool ends = is_over();
            error = draw(frame.alpha, captures_now() || (ends && captures_at_end()));
            if (ends && !error) return true;
            if (!platform.window().is_visible() || !machine_.renderer->waits_for_display())
                wait_for_picture(picture_due_s);
        }
    }

    /// A signal ends the game whatever it answers; but it may save what is to be saved.
    bool end_in_good_order(std::vector<InputEvent>& waiting) {
        if (replay_) return true;
        waiting.push_back({.kind = InputKind::QuitRequested});
        const Outcome error = update(waiting);
        if (error) report(*error);
        return !error;
    }

    /// Until the next picture is due, where no display sets the pace. A picture that took too long is made up
    /// for by shorter waits, but not more than one: after a pause the game goes on at its pace.
    void wait_for_picture(double& due_s) {
        constexpr double kPicture_s = engine::FixedStep::kDefaultStep_s;
        const double now_s = machine_.platform->now_s();
        due_s = std::max(due_s + kPicture_s, now_s - kPicture_s);
        machine_.platform->sleep_s(due_s - now_s);
    }

    bool has_changes() { return reload_ && reload_->has_changes(machine_.platform->now_s()); }

    /// Whether the game that ended with an error may take in what was saved: the error was one of a file that
    /// it has not taken in, or it says what to keep.
    bool can_go_on() const {
        return keeps_game_ || game_->waits_for_scripts() || (is_loaded_ && game_->can_reload());
    }

    /// After the error screen, which saw what keys did meanwhile.
    Outcome go_on() {
        game_->release_input();
        return take_in_changes(!keeps_game_);
    }

    /// What was saved while the game runs. It goes on where it is, unless its scripts have to start anew.
    Outcome take_in_changes(bool has_failed = false) {
        HotReload::Outcome taken = reload_->take_in(*game_, has_failed);
        tools_.forget_past();
        if (taken.wants_restart) return start();
        keeps_game_ = taken.keeps_the_game;
        if (!keeps_game_) is_loaded_ = !taken.error;
        return std::move(taken.error);
    }

    static bool asks_to_quit(const std::vector<InputEvent>& events) {
        for (const InputEvent& event : events) {
            if (event.kind == InputKind::QuitRequested) return true;
        }
        return false;
    }

    /// Whether the game is to be started anew: F5, from within it and from the error screen.
    bool wants_restart() { return tools_.take_restart(); }

    /// True: try again; false: quit.
    bool wait_at_error_screen(const ScriptError& error) {
        ErrorScreen screen = make_error_screen(error, *machine_.files);
        std::vector<InputEvent> events;
        while (!wants_restart()) {
            events.clear();
            machine_.platform->poll_events(events);
            if (machine_.platform->end_signal() != 0) return false;
            for (const InputEvent& event : events) {
                switch (choice_of(event, machine_.renderer->logical_size())) {
                    case ErrorChoice::None:
                        break;
                    case ErrorChoice::TryAgain:
                        return true;
                    case ErrorChoice::Copy:
                        screen.was_copied = copy(error);
                        break;
                    case ErrorChoice::Quit:
                        return false;
                }
            }
            machine_.renderer->begin_frame(machine_.conf.background);
            draw_error_screen(screen, *machine_.renderer);
            machine_.renderer->end_frame();
            machine_.platform->sleep_s(engine::FixedStep::kDefaultStep_s);
            if (has_changes()) return true;
        }
        return true;
    }

    bool copy(const ScriptError& error) {
        const auto copied = machine_.platform->set_clipboard_text(error.to_text());
        if (!copied) fail(copied.error().message);
        return static_cast<bool>(copied);
    }

    static int report(const ScriptError& error) { return fail(error.to_text()); }

    /// A recording of what led to an error is worth most; its state is that of no whole update.
    int finish_with_error() {
        if (!options_.record.empty()) static_cast<void>(write_recording(std::nullopt));
        return 1;
    }

    int finish() {
        if (const auto& result = game_->result(); result && options_.result != nullptr) {
            *options_.result = {result->outcome, result->level};
        } else if (result) {
            std::printf("result: %s\n", engine::printable(result->outcome).c_str());
            if (result->level) std::printf("level: %s\n", engine::printable(*result->level).c_str());
            if (result->score) std::printf("score: %.14g\n", *result->score);
            if (result->stars) std::printf("stars: %lld\n", static_cast<long long>(*result->stars));
        }
        if (options_.print_timings) print_timings();
        if (video_) {
            if (const auto finished = video_->finish(); !finished) return fail(finished.error().message);
        }
        const std::uint64_t hash = game_->state_hash();
        if (options_.print_hash) std::printf("hash: %s\n", hash_text(hash).c_str());
        std::fflush(stdout);
        if (!options_.record.empty()) {
            if (const int status = write_recording(hash); status != 0) return status;
        }
        if (!options_.screenshot.empty() && !is_captured_) {
            return fail("the screenshot " + options_.screenshot + " was to show frame " +
                        std::to_string(*options_.screenshot_frame) + ", but the run ended after frame " +
                        std::to_string(game_->frame()));
        }
        if (replay_ && replay_->hash && game_->frame() == replay_->frames && *replay_->hash != hash) {
            return fail("the replay " + options_.replay + " ended in another state: recorded hash " +
                        hash_text(*replay_->hash) + ", now " + hash_text(hash));
        }
        return 0;
    }

    void print_timings() {
        const FrameTotals& totals = tools_.meter().totals();
        const FrameFigures& slowest = totals.slowest;
        const double frames = static_cast<double>(std::max<std::uint64_t>(totals.frames, 1));
        std::printf("frames: %llu, on average %.2f ms of work, at most %d draw calls\n",
                    static_cast<unsigned long long>(totals.frames), totals.work_ms / frames,
                    totals.draw_calls);
        std::printf("slowest: %.2f ms: update %.2f (physics %.2f), draw %.2f, present %.2f\n",
                    slowest.work_ms(), slowest[FramePart::Update], slowest.physics_ms,
                    slowest[FramePart::Draw], slowest[FramePart::Present]);
    }

    int write_recording(std::optional<std::uint64_t> hash) {
        const Replay recording{.game = options_.source.name,
                               .seed = seed_,
                               .size = machine_.conf.size,
                               .frames = game_->frame(),
                               .hash = hash,
                               .events = recorded_};
        const auto written = engine::write_native_file(options_.record, to_text(recording));
        return written ? 0 : fail("the recording: " + written.error().message);
    }

    const PlayOptions& options_;
    Machine& machine_;
    std::optional<Replay> replay_;
    std::uint64_t seed_ = 1;
    std::optional<std::uint64_t> last_frame_;
    std::unique_ptr<Game> game_;
    Interruption interruption_;  // goes before the game that it watches
    DeveloperTools tools_;
    std::unique_ptr<engine::VideoWriter> video_;
    std::optional<HotReload>
        reload_;               ///< only of games that people play: a recording must not change its files
    bool is_loaded_ = false;   ///< main.lua and cairn.load have run, if need be again, without an error
    bool keeps_game_ = false;  ///< the error at hand is one of a file that was saved; the game is whole
    std::vector<ReplayEvent> recorded_;
    std::size_t next_event_ = 0;
    bool is_captured_ = false;
    std::uint64_t filmed_frame_ = 0;  ///< the last one in the video
};

/// What a recording says about its game must fit the game at hand.
std::optional<std::string> misfit(const Replay& replay, const PlayOptions& options, const Conf& conf) {
    if (replay.game != options.source.name) {
        return "the recording " + options.replay + " is of the game \"" + replay.game + "\", not of \"" +
               options.source.name + '"';
    }
    if (replay.size != conf.size) {
        const auto text = [](engine::Size s) {
            return std::to_string(s.width) + " x " + std::to_string(s.height);
        };
        return "the recording " + options.replay + " was made at " + text(replay.size) +
               " logical pixels; the game now has " + text(conf.size);
    }
    return std::nullopt;
}

}  // namespace

int play(const PlayOptions& given) {
    PlayOptions options = given;
    if (!options.video.empty()) options.headless = true;
    std::optional<Replay> replay;
    if (!options.replay.empty()) {
        auto read = read_replay(options.replay);
        if (!read) return fail(read.error().message);
        replay = *std::move(read);
    }
    // Before somebody plays for it.
    for (const auto& [path, start] :
         {std::pair(options.record, "the recording: "), std::pair(options.screenshot, "")}) {
        if (path.empty()) continue;
        if (const auto fine = engine::check_native_file(path); !fine)
            return fail(start + fine.error().message);
    }
    MachineKind kind = MachineKind::Window;
    if (options.headless)
        kind = options.screenshot.empty() && options.video.empty() ? MachineKind::Headless
                                                                   : MachineKind::HeadlessDrawing;
    auto machine = make_machine(options.source, kind);
    if (!machine) return fail(machine.error().message);
    if (replay) {
        if (const auto problem = misfit(*replay, options, (*machine)->conf)) return fail(*problem);
    }
    return Session(options, **machine, std::move(replay)).run();
}

}  // namespace cairn::scripting
