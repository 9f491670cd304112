// Every test gets a state of its own: the file is run anew for each, and then the one test is called.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>

#include <cairn/engine/native_file.h>
#include <cairn/engine/printable.h>
#include <cairn/scripting/test_game.h>

#include "bind/test_driver.h"
#include "bridge/game.h"
#include "bridge/junit.h"
#include "bridge/machine.h"
#include "bridge/replay.h"

namespace cairn::scripting {
namespace {

class Driver : public TestDriver {
  public:
    Driver(Machine& machine, const GameSource& source, const TestOptions& options)
        : machine_(machine), source_(source), options_(options) {}
    /// The game whose state runs the test.
    void attach(Game& game) { game_ = &game; }

    struct Test {
        std::string name;
        int function;
    };
    [[nodiscard]] const std::vector<Test>& tests() const { return tests_; }

    [[nodiscard]] bool has_test(const std::string& name) const override {
        return std::any_of(tests_.begin(), tests_.end(), [&](const Test& test) { return test.name == name; });
    }
    void add_test(lua_State* L, const std::string& name) override {
        tests_.push_back({name, luaL_ref(L, LUA_REGISTRYINDEX)});
    }

    void start(lua_State* L, std::uint64_t seed) override {
        require_main_thread(L);
        if (is_started_) raise(L, "cairn.test.start: the game of this test runs already");
        is_started_ = true;
        seed_ = seed;
        context_of(L).random = engine::Random(seed);
        machine_.reset_window();
        rethrow(L, game_->load(machine_.main_path, {}));
    }

    void send(lua_State* L, engine::InputEvent event) override {
        require_started(L);
        const std::size_t first = waiting_.size();
        finger_mouse_.append(std::move(event), waiting_);
        for (std::size_t i = first; i < waiting_.size(); ++i) sent_input_.apply(waiting_[i]);
    }
    [[nodiscard]] const engine::InputState& sent_input() const override { return sent_input_; }

    void run_frame(lua_State* L) override {
        require_main_thread(L);
        require_started(L);
        machine_.platform->poll_events(waiting_);
        const std::vector<engine::InputEvent> events = std::move(waiting_);
        waiting_.clear();
        for (const engine::InputEvent& event : events) recorded_.push_back({game_->frame() + 1, event});
        rethrow(L, game_->update(events));
        // As a game without a window: a draw callback that fails must not go unnoticed.
        const auto frames_per_picture = static_cast<std::uint64_t>(machine_.conf.updates_per_second);
        if (game_->frame() % frames_per_picture == 1) rethrow(L, draw());
    }

    std::optional<ScriptError> draw() {
        machine_.renderer->begin_frame(machine_.conf.background);
        auto error = game_->draw(1);
        machine_.renderer->end_frame();
        return error;
    }
    [[nodiscard]] bool is_started() const { return is_started_; }

    std::string state_hash(lua_State* L) override {
        require_started(L);
        return hash_text(game_->state_hash());
    }

    engine::Result<std::optional<GameResult>> play_replay(const std::string& path) override {
        const auto text = machine_.files->read_text(path);
        if (!text) return text.error();
        const auto replay = parse_replay(*text, path);
        if (!replay) return replay.error();
        machine_.reset_window();
        Game game(machine_.services(), {.seed = replay->seed, .plays_saves = true});
        if (const auto error = game.load(machine_.main_path, {})) return engine::Error{error->to_text()};
        auto next = replay->events.begin();
        while (game.frame() < replay->frames && !game.wants_quit()) {
            std::vector<engine::InputEvent> events;
            for (; next != replay->events.end() && next->frame == game.frame() + 1; ++next)
                events.push_back(next->event);
            if (const auto error = game.update(events)) return engine::Error{error->to_text()};
        }
        if (replay->hash && *replay->hash != game.state_hash()) {
            return engine::Error{path + " ended in another state: recorded hash " + hash_text(*replay->hash) +
                                 ", now " + hash_text(game.state_hash())};
        }
        return game.result();
    }

    std::optional<std::string> check_picture(lua_State* L, const std::string& path,
                                             const PictureTolerance& tolerance) override {
        require_main_thread(L);
        require_started(L);
        engine::Renderer& renderer = *machine_.renderer;
        renderer.begin_frame(machine_.conf.background);
        const auto error = game_->draw(1);
        const auto actual = renderer.capture();
        renderer.end_frame();
        rethrow(L, error);
        if (!actual) return actual.error().message;
        if (options_.approves_pictures) return approve(path, *actual);
        return compare(path, *actual, tolerance);
    }

    std::string recording(lua_State* L) override {
        require_started(L);
        return to_text({.game = source_.name,
                        .seed = seed_,
                        .size = machine_.conf.size,
                        .frames = game_->frame(),
                        .hash = game_->state_hash(),
                        .events = recorded_});
    }

  private:
    std::optional<std::string> approve(const std::string& path, const engine::Image& actual) const {
        namespace fs = std::filesystem;
        if (const auto fine = engine::check_virtual_path(path); !fine) return fine.error().message;
        std::error_code failed;
        fs::path root = source_.path;
        if (!fs::is_directory(root, failed)) root = root.parent_path();
        fs::create_directories((root / path).parent_path(), failed);
        if (failed) return "cannot make the folder of " + path + ": " + failed.message();
        if (const auto saved = engine::save_png(actual, (root / path).string()); !saved)
            return saved.error().message;
        return std::nullopt;
    }

    std::optional<std::string> compare(const std::string& path, const engine::Image& actual,
                                       const PictureTolerance& tolerance) const {
        const auto file = machine_.files->read_bytes(path);
        if (!file)
            return "no approved picture: " + file.error().message +
                   "; cairn test GAME --approve-pictures writes it";
        const auto approved = engine::decode_image(*file, path);
        if (!approved) return approved.error().message;
        const auto text = [](engine::Size s) {
            return std::to_string(s.width) + " x " + std::to_string(s.height) + " pixels";
        };
        if (approved->size != actual.size)
            return path + " is " + text(approved->size) + ", and the game draws " + text(actual.size);
        const auto difference = compare_pictures(actual, *approved, tolerance);
        if (!difference) return std::nullopt;
        char share[32];
        std::snprintf(share, sizeof share, "%.3g %%", 100 * difference->share);
        return "the picture is not " + path + ": " + share + " of it is off by more than allowed" +
               keep_difference(path, actual, difference->picture);
    }

    /// Where the pictures lie for who wants to look, or nothing when they cannot be written.
    std::string keep_difference(const std::string& path, const engine::Image& actual,
                                const engine::Image& difference) const {
        namespace fs = std::filesystem;
        std::error_code failed;
        fs::path folder = options_.differences;
        if (folder.empty()) folder = fs::temp_directory_path(failed) / "cairn-differences" / source_.name;
        fs::create_directories(folder, failed);
        const fs::path stem = folder / fs::path(path).stem();
        const std::string of_actual = stem.string() + "-actual.png";
        const std::string of_difference = stem.string() + "-difference.png";
        const auto saved = engine::save_png(actual, of_actual);
        if (!saved) return "; " + saved.error().message;
        if (const auto other = engine::save_png(difference, of_difference); !other)
            return "; " + other.error().message;
        return "; see " + of_difference + " and " + of_actual;
    }

    void require_started(lua_State* L) const {
        if (!is_started_) raise(L, "no game runs; call cairn.test.start first");
    }
    /// The game's callbacks run on the main thread, which cannot go on while a coroutine of it runs.
    void require_main_thread(lua_State* L) const {
        if (L != game_->lua()) raise(L, "cairn.test: a game cannot be run from inside a coroutine");
    }
    static void rethrow(lua_State* L, const std::optional<ScriptError>& error) {
        if (!error) return;
        lua_pushstring(L, error->message.c_str());
        lua_error(L);
    }

    Machine& machine_;
    const GameSource& source_;
    const TestOptions& options_;
    Game* game_ = nullptr;
    std::vector<Test> tests_;
    bool is_started_ = false;
    std::uint64_t seed_ = 1;
    std::vector<engine::InputEvent> waiting_;
    engine::FingerMouse finger_mouse_;
    engine::InputState sent_input_;
    std::vector<ReplayEvent> recorded_;
};

/// A driver and a game with the test file run in it.
struct Bench {
    Bench(Machine& machine, const GameSource& source, const TestOptions& options)
        : driver(machine, source, options), game(machine.services(), {.plays_saves = true, .test = &driver}) {
        driver.attach(game);
    }

    Driver driver;
    Game game;
};

/// Runs the tests, file by file, and prints what comes of each.
class Runner {
  public:
    Runner(Machine& machine, const GameSource& source, const TestOptions& options)
        : machine_(machine), source_(source), options_(options) {}

    void run_file(const std::string& path) {
        std::printf("%s\n", path.c_str());
        std::size_t count = 0;
        {
            Bench bench(machine_, source_, options_);
            if (auto error = bench.game.run_file(path)) {
                add({.file = path, .name = "the file itself", .error = std::move(error)});
                return;
            }
            count = bench.driver.tests().size();
        }
        for (std::size_t i = 0; i < count; ++i) run_test(path, i);
    }

    [[nodiscard]] const std::vector<TestResult>& results() const { return results_; }
    [[nodiscard]] int failed() const { return failed_; }

  private:
    void run_test(const std::string& path, std::size_t index) {
        const auto start = std::chrono::steady_clock::now();
        Bench bench(machine_, source_, options_);
        TestResult result{.file = path, .name = "test " + std::to_string(index + 1)};
        result.error = bench.game.run_file(path);
        if (!result.error && index < bench.driver.tests().size()) {
            const Driver::Test& test = bench.driver.tests()[index];
            result.name = test.name;
            lua_rawgeti(bench.game.lua(), LUA_REGISTRYINDEX, test.function);
            result.error = protected_call(bench.game.lua(), 0, 0);
            if (!result.error && bench.driver.is_started()) result.error = bench.driver.draw();
        }
        result.duration_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        add(std::move(result));
    }

    void add(TestResult result) {
        std::printf("  %s  %s\n", result.error ? "FAIL" : "ok  ", engine::printable(result.name).c_str());
        if (result.error) {
            ++failed_;
            std::printf("        %s\n", engine::printable(result.error->message).c_str());
            for (const std::string& line : result.error->traceback)
                std::printf("            %s\n", engine::printable(line).c_str());
        }
        results_.push_back(std::move(result));
    }

    Machine& machine_;
    const GameSource& source_;
    const TestOptions& options_;
    std::vector<TestResult> results_;
    int failed_ = 0;
};

bool is_lua_file(const std::string& name) {
    return name.size() > 4 && name.substr(name.size() - 4) == ".lua";
}

/// Paths of the files with tests.
std::vector<std::string> test_files(const engine::Files& files) {
    std::vector<std::string> paths;
    if (const auto names = files.list("tests")) {
        for (const std::string& name : *names) {
            if (is_lua_file(name)) paths.push_back("tests/" + name);
        }
    }
    return paths;
}

/// Drawing costs time and textures, which tests that never look need not pay.
bool compares_pictures(const engine::Files& files) {
    for (const std::string& path : test_files(files)) {
        const auto text = files.read_text(path);
        if (text && text->find("expect_picture") != std::string::npos) return true;
    }
    return false;
}

int fail(const std::string& message) {
    std::fflush(stdout);
    std::fprintf(stderr, "cairn: error: %s\n", engine::printable(message).c_str());
    return 1;
}

}  // namespace

int test_game(const GameSource& source, const TestOptions& options) {
    if (!options.junit.empty()) {
        if (const auto fine = engine::check_native_file(options.junit); !fine)
            return fail("the results: " + fine.error().message);
    }
    auto machine = make_machine(source, MachineKind::Headless);
    if (!machine) return fail(machine.error().message);
    if (compares_pictures(*(*machine)->files)) {
        machine->reset();  // there can be one at a time
        machine = make_machine(source, MachineKind::HeadlessDrawing);
        if (!machine) return fail(machine.error().message);
    }
    Runner runner(**machine, source, options);
    for (const std::string& path : test_files(*(*machine)->files)) runner.run_file(path);
    const std::size_t count = runner.results().size();
    if (count == 0)
        return fail(source.path + " has no tests: expected tests/*.lua that call cairn.test.test");
    std::printf("%zu test%s, %d failed\n", count, count == 1 ? "" : "s", runner.failed());
    std::fflush(stdout);
    if (!options.junit.empty()) {
        const auto written =
            engine::write_native_file(options.junit, junit_xml(source.name, runner.results()));
        if (!written) return fail("the results: " + written.error().message);
    }
    return runner.failed() == 0 ? 0 : 1;
}

}  // namespace cairn::scripting
