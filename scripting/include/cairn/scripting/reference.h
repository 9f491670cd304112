// What the bindings say about themselves.
#pragma once

#include <string>

namespace cairn::scripting {

/// The Lua reference in Markdown: docs/reference/lua.md.
std::string reference_markdown();

/// The format of levels in Markdown: docs/reference/levels.md.
std::string level_reference_markdown();

/// Annotations for the Lua language server: scripting/types/cairn.lua.
std::string editor_annotations();

}  // namespace cairn::scripting
