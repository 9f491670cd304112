// Fuzz target: any sequence of calls leaves a world whose numbers are finite and whose lists and events agree
// with what was done, that knows which handles are good, and that does the same again when it gets the same
// calls, on one thread or two.
#include <vector>

#include "fuzz/branch_counts.h"
#include "fuzz/world/session.h"

using namespace cairn::physics;

namespace {

// What one run on several threads gives. It counts for nothing: which thread takes which piece of the work is
// up to the machine, and the inputs that come next would be too.
std::uint64_t hash_on_threads(fuzz::Input in, int threads) {
    const std::vector<std::uint8_t> counts = fuzz::branch_counts();
    const std::uint64_t hash = fuzz::Session(in, threads).run();
    fuzz::set_branch_counts(counts);
    return hash;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::Input in(data, size);
    const int again = in.below(8);
    const std::uint64_t hash = fuzz::Session(in, 1).run();
    if (again == 0) fuzz::require(fuzz::Session(in, 1).run() == hash, "the same calls give the same bits");
    if (again == 1) fuzz::require(hash_on_threads(in, 2) == hash, "two threads give the same bits as one");
    return 0;
}
