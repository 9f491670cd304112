// SDL's own handlers make of a signal the event that a click on the window's close button makes, which a game
// may refuse.
#include "platform/sdl/end_signals.h"

#include <atomic>

namespace cairn::engine {
namespace {

volatile std::sig_atomic_t received_signal = 0;
std::atomic<void (*)()> called = nullptr;
static_assert(std::atomic<void (*)()>::is_always_lock_free);  // a handler must not wait

void note(int signal) {
    received_signal = signal;
    if (const auto call = called.load()) call();
}

}  // namespace

EndSignals::EndSignals() {
    received_signal = 0;
    called = nullptr;
    for (std::size_t i = 0; i < kSignals.size(); ++i) {
        struct sigaction before = {};
        if (sigaction(kSignals[i], nullptr, &before) != 0 || before.sa_handler != SIG_DFL) continue;
        struct sigaction ours = {};
        ours.sa_handler = note;
        // The system's own answer is back after the first: for a game that hangs. Calls go on where they
        // were.
        ours.sa_flags = static_cast<int>(SA_RESETHAND) | SA_RESTART;
        is_ours_[i] = sigaction(kSignals[i], &ours, nullptr) == 0;
    }
}

EndSignals::~EndSignals() {
    for (std::size_t i = 0; i < kSignals.size(); ++i) {
        if (is_ours_[i]) std::signal(kSignals[i], SIG_DFL);
    }
}

void EndSignals::call_on_first(void (*call)()) {
    called = call;
}

int EndSignals::received() {
    return received_signal;
}

}  // namespace cairn::engine
