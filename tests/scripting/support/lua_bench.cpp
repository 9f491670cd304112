// The folder lies below the system's folder for temporary files.
#include "scripting/support/lua_bench.h"

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <unistd.h>

#include "lua/sandbox.h"
#include "support/source_path.h"

namespace cairn::scripting::test {

namespace fs = std::filesystem;

GameFolder::GameFolder(const GameFiles& files) {
    static int made = 0;
    path_ = (fs::temp_directory_path() /
             ("cairn-test-" + std::to_string(getpid()) + '-' + std::to_string(++made)))
                .string();
    fs::create_directories(path_);
    std::ofstream(fs::path(path_) / "main.lua") << "-- nothing to do\n";
    for (const auto& [name, text] : files) {
        const fs::path file = fs::path(path_) / name;
        fs::create_directories(file.parent_path());
        std::ofstream(file, std::ios::binary) << text;
    }
}

GameFolder::~GameFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
}

GameSource GameFolder::source() const {
    return {.program_path = "scripting-tests",
            .path = path_,
            .name = "bench",
            .assets = {cairn::test::source_path("assets")},
            .save_root = path_ + "/saves"};
}

LuaBench::LuaBench(const GameFiles& files, MachineKind kind, GameOptions options) : folder_(files) {
    auto machine = make_machine(folder_.source(), kind);
    if (!machine) FAIL(machine.error().message);
    machine_ = *std::move(machine);
    game_ = std::make_unique<Game>(machine_->services(), options);
}

std::string LuaBench::run(const std::string& code) {
    lua_State* L = game_->lua();
    if (const auto error = load_text(L, code, "test.lua")) return error->message;
    if (const auto error = protected_call(L, 0, 0)) return error->message;
    return "";
}

std::string LuaBench::value(const std::string& expression) {
    lua_State* L = game_->lua();
    if (const auto error = load_text(L, "return " + expression, "test.lua"))
        return "error: " + error->message;
    if (const auto error = protected_call(L, 0, 1)) return "error: " + error->message;
    push_text(L, -1);
    std::string text = lua_tostring(L, -1);
    lua_pop(L, 2);
    return text;
}

}  // namespace cairn::scripting::test
