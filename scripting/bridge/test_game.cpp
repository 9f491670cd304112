// Every test gets a state of its own: the file is run anew for each, and then the one test is called.
#include <cstdio>

#include <cairn/scripting/test_game.h>

#include "bind/test_driver.h"
#include "bridge/game.h"
#include "bridge/machine.h"
#include "bridge/replay.h"

namespace cairn::scripting {
namespace {

class Driver : public TestDriver {
  public:
    Driver(Machine& machine, const std::string& game_name) : machine_(machine), game_name_(game_name) {}
    /// The game whose state runs the test.
    void attach(Game& game) { game_ = &game; }

    struct Test {
        std::string name;
        int function;
    };
    [[nodiscard]] const std::vector<Test>& tests() const { return tests_; }

    void add_test(lua_State* L, const std::string& name) override {
        tests_.push_back({name, luaL_ref(L, LUA_REGISTRYINDEX)});
    }

    void start(lua_State* L, std::uint64_t seed) override {
        require_main_thread(L);
        if (is_started_) raise(L, "cairn.test.start: the game of this test runs already");
        is_started_ = true;
        seed_ = seed;
        context_of(L).random = engine::Random(seed);
        rethrow(L, game_->load(machine_.main_path, {}));
    }

    void send(lua_State* L, engine::InputEvent event) override {
        require_started(L);
        waiting_.push_back(std::move(event));
    }

    void run_frame(lua_State* L) override {
        require_main_thread(L);
        require_started(L);
        const std::vector<engine::InputEvent> events = std::move(waiting_);
        waiting_.clear();
        for (const engine::InputEvent& event : events) recorded_.push_back({game_->frame() + 1, event});
        rethrow(L, game_->update(events));
    }

    std::string state_hash(lua_State* L) override {
        require_started(L);
        return hash_text(game_->state_hash());
    }

    engine::Result<std::optional<GameResult>> play_replay(const std::string& path) override {
        const auto text = machine_.files->read_text(path);
        if (!text) return text.error();
        const auto replay = parse_replay(*text, path);
        if (!replay) return replay.error();
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

    std::string recording(lua_State* L) override {
        require_started(L);
        return to_text({.game = game_name_,
                        .seed = seed_,
                        .size = machine_.conf.size,
                        .frames = game_->frame(),
                        .hash = game_->state_hash(),
                        .events = recorded_});
    }

  private:
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
    const std::string& game_name_;
    Game* game_ = nullptr;
    std::vector<Test> tests_;
    bool is_started_ = false;
    std::uint64_t seed_ = 1;
    std::vector<engine::InputEvent> waiting_;
    std::vector<ReplayEvent> recorded_;
};

/// A driver and a game with the test file run in it.
struct Bench {
    Bench(Machine& machine, const std::string& game_name)
        : driver(machine, game_name), game(machine.services(), {.plays_saves = true, .test = &driver}) {
        driver.attach(game);
    }

    Driver driver;
    Game game;
};

void print_error(const ScriptError& error) {
    std::printf("        %s\n", error.message.c_str());
    for (const std::string& line : error.traceback) std::printf("            %s\n", line.c_str());
}

struct Tally {
    int run = 0;
    int failed = 0;
};

void run_test(Machine& machine, const std::string& game_name, const std::string& path, std::size_t index,
              Tally& tally) {
    Bench bench(machine, game_name);
    std::optional<ScriptError> error = bench.game.run_file(path);
    std::string name = "test " + std::to_string(index + 1);
    if (!error && index < bench.driver.tests().size()) {
        const Driver::Test& test = bench.driver.tests()[index];
        name = test.name;
        lua_rawgeti(bench.game.lua(), LUA_REGISTRYINDEX, test.function);
        error = protected_call(bench.game.lua(), 0, 0);
    }
    ++tally.run;
    std::printf("  %s  %s\n", error ? "FAIL" : "ok  ", name.c_str());
    if (!error) return;
    ++tally.failed;
    print_error(*error);
}

void run_file(Machine& machine, const std::string& game_name, const std::string& path, Tally& tally) {
    std::printf("%s\n", path.c_str());
    std::size_t count = 0;
    {
        Bench bench(machine, game_name);
        if (const auto error = bench.game.run_file(path)) {
            ++tally.run;
            ++tally.failed;
            std::printf("  FAIL  the file itself\n");
            print_error(*error);
            return;
        }
        count = bench.driver.tests().size();
    }
    for (std::size_t i = 0; i < count; ++i) run_test(machine, game_name, path, i, tally);
}

bool is_lua_file(const std::string& name) {
    return name.size() > 4 && name.substr(name.size() - 4) == ".lua";
}

}  // namespace

int test_game(const GameSource& source) {
    auto machine = make_machine(source, MachineKind::Headless);
    if (!machine) {
        std::fprintf(stderr, "cairn: error: %s\n", machine.error().message.c_str());
        return 1;
    }
    const auto names = (*machine)->files->list("tests");
    Tally tally;
    if (names) {
        for (const std::string& name : *names) {
            if (is_lua_file(name)) run_file(**machine, source.name, "tests/" + name, tally);
        }
    }
    std::fflush(stdout);
    if (tally.run == 0) {
        std::fprintf(stderr,
                     "cairn: error: %s has no tests: expected tests/*.lua that call cairn.test.test\n",
                     source.path.c_str());
        return 1;
    }
    std::printf("%d test%s, %d failed\n", tally.run, tally.run == 1 ? "" : "s", tally.failed);
    return tally.failed == 0 ? 0 : 1;
}

}  // namespace cairn::scripting
