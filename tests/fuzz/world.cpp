// Fuzz target: any sequence of calls leaves a world whose numbers are finite and whose lists and events agree
// with what was done, that knows which handles are good, and that does the same again when it gets the same
// calls, on one thread or two.
#include "fuzz/world/session.h"

using namespace cairn::physics;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::Input in(data, size);
    const int again = in.below(8);
    const std::uint64_t hash = fuzz::Session(in, 1).run();
    if (again == 0) fuzz::require(fuzz::Session(in, 1).run() == hash, "the same calls give the same bits");
    if (again == 1) {
        fuzz::require(fuzz::Session(in, 2).run() == hash, "two threads give the same bits as one");
    }
    return 0;
}
