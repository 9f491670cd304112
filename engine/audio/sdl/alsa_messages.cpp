// Where there is no sound device, ALSA's library prints a line for each way on which it looked for one. Its
// handler is set by name, because SDL need not be built with ALSA: where it is, the library is loaded
// already.
#include "audio/sdl/alsa_messages.h"

#include <SDL.h>

namespace cairn::engine {
namespace {

using Handler = void (*)(const char* file, int line, const char* function, int error, const char* format,
                         ...);
using SetHandler = int (*)(Handler);

void say_nothing(const char*, int, const char*, int, const char*, ...) {}

}  // namespace

void silence_alsa() {
    // Stays loaded: the handler is the library's from now on.
    static void* const library = SDL_LoadObject("libasound.so.2");
    if (library == nullptr) return;
    const auto set_handler =
        reinterpret_cast<SetHandler>(SDL_LoadFunction(library, "snd_lib_error_set_handler"));
    if (set_handler != nullptr) set_handler(say_nothing);
}

}  // namespace cairn::engine
