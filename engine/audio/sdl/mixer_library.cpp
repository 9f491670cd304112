// Names become functions. Invariant: the table is filled whole or not at all.
#include "audio/sdl/mixer_library.h"

#include <SDL.h>
#include <optional>
#include <string>

namespace cairn::engine {
namespace {

/// The name that stands for its binary interface, whatever its version.
constexpr const char* kFileName = "libSDL2_mixer-2.0.so.0";

std::optional<MixerLibrary>& loaded() {
    static std::optional<MixerLibrary> library;
    return library;
}

/// Finds functions; the first that is missing ends it.
class Finder {
  public:
    explicit Finder(void* file) : file_(file) {}

    template <class Function>
    void find(const char* name, Function*& function) {
        if (is_whole_) function = reinterpret_cast<Function*>(SDL_LoadFunction(file_, name));
        is_whole_ = is_whole_ && function != nullptr;
    }
    [[nodiscard]] bool is_whole() const { return is_whole_; }

  private:
    void* file_;
    bool is_whole_ = true;
};

}  // namespace

Result<void> load_mixer() {
    if (loaded()) return {};
    void* file = SDL_LoadObject(kFileName);
    if (file == nullptr) return Error{SDL_GetError()};
    MixerLibrary library;
    Finder finder(file);
    finder.find("Mix_AllocateChannels", library.AllocateChannels);
    finder.find("Mix_CloseAudio", library.CloseAudio);
    finder.find("Mix_FreeChunk", library.FreeChunk);
    finder.find("Mix_FreeMusic", library.FreeMusic);
    finder.find("Mix_HaltChannel", library.HaltChannel);
    finder.find("Mix_HaltMusic", library.HaltMusic);
    finder.find("Mix_LoadMUS_RW", library.LoadMUS_RW);
    finder.find("Mix_LoadWAV_RW", library.LoadWAV_RW);
    finder.find("Mix_OpenAudioDevice", library.OpenAudioDevice);
    finder.find("Mix_Pause", library.Pause);
    finder.find("Mix_PauseMusic", library.PauseMusic);
    finder.find("Mix_PlayChannel", library.PlayChannel);
    finder.find("Mix_PlayMusic", library.PlayMusic);
    finder.find("Mix_Playing", library.Playing);
    finder.find("Mix_PlayingMusic", library.PlayingMusic);
    finder.find("Mix_QuickLoad_RAW", library.QuickLoad_RAW);
    finder.find("Mix_RegisterEffect", library.RegisterEffect);
    finder.find("Mix_Resume", library.Resume);
    finder.find("Mix_ResumeMusic", library.ResumeMusic);
    finder.find("Mix_SetPanning", library.SetPanning);
    finder.find("Mix_Volume", library.Volume);
    finder.find("Mix_VolumeMusic", library.VolumeMusic);
    if (!finder.is_whole()) return Error{SDL_GetError()};
    loaded() = library;
    return {};
}

const MixerLibrary& mixer() {
    return *loaded();
}

}  // namespace cairn::engine
