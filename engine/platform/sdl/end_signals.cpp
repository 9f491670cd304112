// SDL's own handlers make of a signal the event that a click on the window's close button makes, which a game
// may refuse.
#include "platform/sdl/end_signals.h"

namespace cairn::engine {
namespace {

volatile std::sig_atomic_t received_signal = 0;

void note(int signal) {
    received_signal = signal;
}

}  // namespace

EndSignals::EndSignals() {
    received_signal = 0;
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

int EndSignals::received() {
    return received_signal;
}

}  // namespace cairn::engine
