#include "support/source_path.h"

namespace cairn::test {

std::string source_path(std::string_view relative) {
    return std::string(CAIRN_SOURCE_DIR "/").append(relative);
}

}  // namespace cairn::test
