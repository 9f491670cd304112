// The parts of the reference as Markdown, for the whole of it and for what is asked for by name.
#pragma once

#include <string>

#include "bind/callbacks.h"
#include "bind/module.h"

namespace cairn::scripting {

/// "world:step" or "cairn.audio.play": as a script writes it.
std::string call_text(const Function& function, const Module& module);
/// "world:step(dt)", with its results.
std::string signature(const Function& function, const Module& module);
/// "cairn.key_pressed(key, is_repeat)".
std::string signature(const Callback& callback);

/// With its description and its fields.
void write_function(const Function& function, const Module& module, std::string& out);
void write_callbacks(std::string& out);
void write_conf(std::string& out);

}  // namespace cairn::scripting
