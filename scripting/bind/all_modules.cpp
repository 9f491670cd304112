// The global table `cairn`: which module goes where.
#include <array>
#include <string_view>

#include "bind/context.h"
#include "bind/modules.h"
#include "bind/object_data.h"
#include "bind/physics_objects.h"
#include "lua/state.h"

namespace cairn::scripting {
namespace {

// In the order of the reference.
constexpr std::array kModules = {
    &kCoreModule,   &kPhysicsModule,   &kWorldMethods,     &kBodyMethods,       &kShapeMethods,
    &kChainMethods, &kJointMethods,    &kMoverMethods,     &kTransformsMethods, &kRecordingMethods,
    &kPrefabModule, &kPrefabMethods,   &kCameraModule,     &kCameraMethods,     &kGraphicsModule,
    &kImageMethods, &kFontMethods,     &kCanvasMethods,    &kQuadMethods,       &kAtlasMethods,
    &kBatchMethods, &kParticlesModule, &kParticlesMethods, &kTileMapModule,     &kTileMapMethods,
    &kUiModule,     &kUiMethods,       &kTextModule,       &kTextMethods,       &kAudioModule,
    &kInputModule,  &kWindowModule,    &kFilesModule,      &kRandomModule,      &kRandomMethods,
    &kTimerModule,  &kTimerMethods,    &kTweenModule,      &kTweenMethods,      &kSceneModule,
    &kDataModule,   &kLevelModule,     &kLevelMethods,     &kTestModule,
};

struct TypeOfObject {
    ObjectTag tag;
    const Module* methods;
    lua_CFunction finalize;
};
constexpr TypeOfObject kTypes[] = {
    {ObjectTag::World, &kWorldMethods, finalize_world},
    {ObjectTag::Body, &kBodyMethods, nullptr},
    {ObjectTag::Camera, &kCameraMethods, nullptr},
    {ObjectTag::Image, &kImageMethods, nullptr},
    {ObjectTag::Font, &kFontMethods, nullptr},
    {ObjectTag::Random, &kRandomMethods, nullptr},
    {ObjectTag::Particles, &kParticlesMethods, finalize_particles},
    {ObjectTag::TileMap, &kTileMapMethods, finalize_tile_map},
    {ObjectTag::Ui, &kUiMethods, finalize_ui},
    {ObjectTag::Text, &kTextMethods, finalize_text},
    {ObjectTag::Transforms, &kTransformsMethods, finalize_transforms},
    {ObjectTag::Recording, &kRecordingMethods, finalize_recording},
    {ObjectTag::Mover, &kMoverMethods, finalize_mover},
    {ObjectTag::Level, &kLevelMethods, finalize_level},
    {ObjectTag::Tween, &kTweenMethods, nullptr},
    {ObjectTag::Timer, &kTimerMethods, nullptr},
    {ObjectTag::Prefab, &kPrefabMethods, finalize_prefab},
    {ObjectTag::Canvas, &kCanvasMethods, finalize_canvas},
    {ObjectTag::Quad, &kQuadMethods, nullptr},
    {ObjectTag::Atlas, &kAtlasMethods, nullptr},
    {ObjectTag::Batch, &kBatchMethods, finalize_batch},
};

}  // namespace

std::span<const Module* const> all_modules() {
    return kModules;
}

void register_all(lua_State* L) {
    for (const TypeOfObject& type : kTypes) register_type(L, type.tag, *type.methods, type.finalize);
    register_type_with_data(L, ObjectTag::Shape, kShapeMethods);
    register_type_with_data(L, ObjectTag::Chain, kChainMethods);
    register_type_with_data(L, ObjectTag::Joint, kJointMethods);
    register_event_cursor(L);
    lua_newtable(L);  // cairn
    for (const Module* module : kModules) {
        if (module->is_type || module == &kCoreModule) continue;
        // cairn.test is there only where tests run, so that a game cannot come to depend on it.
        if (module == &kTestModule && context_of(L).test == nullptr) continue;
        lua_newtable(L);
        if (module == &kRandomModule) install_random(L);
        fill_table(L, *module);
        lua_setfield(L, -2, std::string(module->short_name()).c_str());
    }
    add_functions(L, kCoreModule);
    lua_pushliteral(L, CAIRN_VERSION);
    lua_setfield(L, -2, "version");
    guard_members(L);
    lua_setglobal(L, "cairn");
    install_require(L);
}

}  // namespace cairn::scripting
