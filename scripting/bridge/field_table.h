// Described fields as a table in Markdown.
#pragma once

#include <span>
#include <string>

#include "bind/fields.h"

namespace cairn::scripting {

std::string field_table(std::span<const Field* const> fields);

}  // namespace cairn::scripting
