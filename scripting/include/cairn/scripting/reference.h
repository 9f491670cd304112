// What the bindings say about themselves.
#pragma once

#include <string>
#include <string_view>

#include <cairn/engine/result.h>

namespace cairn::scripting {

/// The Lua reference in Markdown: docs/reference/lua.md.
std::string reference_markdown();

/// What the reference says about a name as an author would type it: a module or a type ("audio", "World")
/// with the calls it has, "callbacks" and "conf.lua", or all functions, callbacks and fields that are called
/// so ("world:step", "cairn.audio.play", "play", "key_pressed", "density", "vsync"). What other frameworks
/// call it is found too ("hinge", "newImage"). The error names the nearest.
engine::Result<std::string> reference_of(std::string_view name);

/// The format of levels in Markdown: docs/reference/levels.md.
std::string level_reference_markdown();

/// Annotations for the Lua language server: scripting/types/cairn.lua.
std::string editor_annotations();

}  // namespace cairn::scripting
