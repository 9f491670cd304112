// Finds the game's files and opens what it needs.
#include "bridge/machine.h"

#include <filesystem>

namespace cairn::scripting {
namespace {

namespace fs = std::filesystem;

engine::Result<std::unique_ptr<engine::Files>> open_files(const GameSource& source, const std::string& root,
                                                          const std::string& identity) {
    auto files = engine::Files::create(
        {.program_path = source.program_path, .identity = identity, .save_root = source.save_root});
    if (!files) return files.error();
    if (auto mounted = (*files)->mount(root); !mounted) return mounted.error();
    for (const std::string& assets : source.assets) {
        if (auto mounted = (*files)->mount(assets); !mounted) return mounted.error();
    }
    return files;
}

engine::Result<Conf> read_conf(const engine::Files& files, const std::string& game_name) {
    if (!files.exists("conf.lua")) return default_conf(game_name);
    const auto text = files.read_text("conf.lua");
    if (!text) return text.error();
    return parse_conf(*text, "conf.lua", game_name);
}

}  // namespace

engine::Result<std::unique_ptr<Machine>> make_machine(const GameSource& source, MachineKind kind,
                                                      ConfSlips slips) {
    auto machine = std::make_unique<Machine>();
    std::error_code ignored;
    std::string root = source.path;
    machine->main_path = "main.lua";
    if (fs::is_regular_file(source.path, ignored) && fs::path(source.path).extension() == ".lua") {
        const fs::path file = fs::absolute(source.path, ignored);
        root = file.parent_path().string();
        machine->main_path = file.filename().string();
    }
    // The name of the save folder stands in a file of the game, so the files are opened twice.
    {
        auto files = open_files(source, root, "");
        if (!files) return files.error();
        if (!(*files)->exists(machine->main_path)) {
            return engine::Error{"\"" + source.path + "\" is no game: it holds no " + machine->main_path};
        }
        auto conf = read_conf(**files, source.name);
        if (!conf && slips != ConfSlips::Passed) return conf.error();
        machine->conf = conf ? *std::move(conf) : default_conf(source.name);
    }
    auto files = open_files(source, root, machine->conf.identity);
    if (!files) return files.error();
    machine->files = *std::move(files);

    auto platform = engine::Platform::create({.headless = kind != MachineKind::Window,
                                              .headless_drawing = kind == MachineKind::HeadlessDrawing,
                                              .window = machine->conf.window()});
    if (!platform) return platform.error();
    machine->platform = *std::move(platform);
    auto renderer = machine->platform->create_renderer(*machine->files);
    if (!renderer) return renderer.error();
    machine->renderer = *std::move(renderer);
    machine->audio = machine->platform->create_audio(*machine->files);
    return machine;
}

}  // namespace cairn::scripting
