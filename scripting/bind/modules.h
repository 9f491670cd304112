// The modules, one per file, and what builds their Lua side. To add one: describe it in a file of its own,
// declare it here, and list it in all_modules.cpp.
#pragma once

#include <lua.hpp>

#include "bind/module.h"

namespace cairn::scripting {

extern const Module kCoreModule;     // cairn
extern const Module kPhysicsModule;  // cairn.physics
extern const Module kWorldMethods;
extern const Module kBodyMethods;
extern const Module kShapeMethods;
extern const Module kChainMethods;
extern const Module kJointMethods;
extern const Module kMoverMethods;
extern const Module kTransformsMethods;
extern const Module kRecordingMethods;
extern const Module kPrefabModule;  // cairn.prefab
extern const Module kPrefabMethods;
extern const Module kCameraModule;  // cairn.camera
extern const Module kCameraMethods;
extern const Module kGraphicsModule;  // cairn.graphics
extern const Module kImageMethods;
extern const Module kFontMethods;
extern const Module kCanvasMethods;
extern const Module kQuadMethods;
extern const Module kAtlasMethods;
extern const Module kBatchMethods;
extern const Module kParticlesModule;  // cairn.particles
extern const Module kParticlesMethods;
extern const Module kTileMapModule;  // cairn.tilemap
extern const Module kTileMapMethods;
extern const Module kUiModule;  // cairn.ui
extern const Module kUiMethods;
extern const Module kTextModule;  // cairn.text
extern const Module kTextMethods;
extern const Module kAudioModule;   // cairn.audio
extern const Module kInputModule;   // cairn.input
extern const Module kWindowModule;  // cairn.window
extern const Module kFilesModule;   // cairn.files
extern const Module kRandomModule;  // cairn.random
extern const Module kRandomMethods;
extern const Module kTimerModule;  // cairn.timer
extern const Module kTimerMethods;
extern const Module kTweenModule;  // cairn.tween
extern const Module kTweenMethods;
extern const Module kSceneModule;  // cairn.scene
extern const Module kDataModule;   // cairn.data
extern const Module kLevelModule;  // cairn.level
extern const Module kLevelMethods;
extern const Module kTestModule;  // cairn.test

/// Frees what a World holds; the finalizer of its type.
int finalize_world(lua_State* L);
/// The same of a Prefab.
int finalize_prefab(lua_State* L);

/// Frees the texture of a Canvas, the sprites of a Batch, the particles of a Particles, a TileMap's map, a
/// Ui's widgets.
int finalize_canvas(lua_State* L);
int finalize_batch(lua_State* L);
int finalize_particles(lua_State* L);
int finalize_tile_map(lua_State* L);
int finalize_ui(lua_State* L);
int finalize_text(lua_State* L);
/// Frees what a Mover or a Level holds.
int finalize_mover(lua_State* L);
int finalize_transforms(lua_State* L);
int finalize_recording(lua_State* L);
int finalize_level(lua_State* L);

/// Adds `cairn.random.visual` to the table on top of the stack, and makes math.random use the gameplay
/// stream.
void install_random(lua_State* L);

/// From now on asking the table on top of the stack, `cairn`, for a name that is nearly one of its modules or
/// functions raises an error that names it. Other names that it lacks are nil: callbacks that the game has
/// not, and what the game may put there itself. A callback that is no function is an error too.
void guard_members(lua_State* L);

/// Makes the global `require`, which runs only the game's own files.
void install_require(lua_State* L);

}  // namespace cairn::scripting
