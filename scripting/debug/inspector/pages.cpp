// Values of the script, assets, and the log.
#include "debug/inspector/pages.h"

#include <imgui.h>

namespace cairn::scripting {
namespace {

void show_value(const LuaValue& value) {
    if (value.members.empty()) {
        ImGui::BulletText("%s = %s", value.name.c_str(), value.text.c_str());
        return;
    }
    if (!ImGui::TreeNode(value.name.c_str(), "%s: %s", value.name.c_str(), value.text.c_str())) return;
    for (const LuaValue& member : value.members) show_value(member);
    if (value.is_cut) ImGui::TextDisabled("...");
    ImGui::TreePop();
}

ImVec4 color_of(engine::LogLevel level) {
    switch (level) {
        case engine::LogLevel::Debug:
            return {0.6f, 0.65f, 0.7f, 1};
        case engine::LogLevel::Info:
            return {0.92f, 0.93f, 0.94f, 1};
        case engine::LogLevel::Warning:
            return {0.95f, 0.76f, 0.46f, 1};
        case engine::LogLevel::Error:
            return {0.98f, 0.5f, 0.4f, 1};
    }
    return {};
}

}  // namespace

void show_script_page(const std::vector<LuaValue>& values) {
    ImGui::TextDisabled("Globals, and the local variables that callbacks use.");
    for (const LuaValue& value : values) show_value(value);
}

void show_assets_page(const Context& context) {
    const engine::AudioStats audio = context.services.audio.stats();
    const std::string& music = context.services.audio.music();
    ImGui::Text("Sound device %s; %d voices, music: %s", audio.device_open ? "open" : "closed",
                audio.active_voices, music.empty() ? "none" : music.c_str());
    ImGui::Text("%ld sounds played, %ld refused by limits", audio.plays, audio.refused);
    const std::vector<std::string> sounds = context.services.audio.loaded_sounds();
    if (ImGui::TreeNode("sounds", "%zu sounds", sounds.size())) {
        for (const std::string& sound : sounds) ImGui::BulletText("%s", sound.c_str());
        ImGui::TreePop();
    }
    const std::vector<engine::TextureInfo> textures = context.services.renderer.loaded_textures();
    double megabytes = 0;
    for (const engine::TextureInfo& texture : textures)
        megabytes += 4e-6 * texture.size.width * texture.size.height;
    if (ImGui::TreeNode("textures", "%zu textures, %.1f MB", textures.size(), megabytes)) {
        for (const engine::TextureInfo& texture : textures) {
            const char* name = texture.is_canvas      ? "(canvas)"
                               : texture.path.empty() ? "(made)"
                                                      : texture.path.c_str();
            ImGui::BulletText("%s, %d x %d", name, texture.size.width, texture.size.height);
        }
        ImGui::TreePop();
    }
    const engine::RenderStats& stats = context.services.renderer.stats();
    ImGui::Text("%d draw calls, %d triangles", stats.draw_calls, stats.triangles);
}

void show_log_page(const std::vector<LogLine>& lines) {
    if (lines.empty()) ImGui::TextDisabled("Nothing was logged since the inspector was opened.");
    for (const LogLine& line : lines) {
        ImGui::PushStyleColor(ImGuiCol_Text, color_of(line.level));
        ImGui::TextWrapped("%s", line.text.c_str());
        ImGui::PopStyleColor();
    }
}

}  // namespace cairn::scripting
