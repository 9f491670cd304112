// Names of the stages.
#include <cairn/physics/profile.h>

namespace cairn::physics {

std::string_view name(Stage stage) {
    switch (stage) {
        case Stage::Pairs:
            return "pairs";
        case Stage::Contacts:
            return "contacts";
        case Stage::Prepare:
            return "prepare";
        case Stage::Solve:
            return "solve";
        case Stage::Store:
            return "store";
        case Stage::Finalize:
            return "finalize";
        case Stage::Continuous:
            return "continuous";
        case Stage::Sensors:
            return "sensors";
        case Stage::Sleep:
            return "sleep";
    }
    return "unknown";
}

}  // namespace cairn::physics
