// In place of the inspector where Dear ImGui is not installed.
#include "debug/inspector.h"

namespace cairn::scripting {

engine::Result<std::unique_ptr<Inspector>> Inspector::create(const Services&) {
    return engine::Error{
        "the inspector needs Dear ImGui, without which this program was built (on Debian: libimgui-dev)"};
}

}  // namespace cairn::scripting
