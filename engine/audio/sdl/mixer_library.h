// SDL2_mixer, taken in when the first sound is played. It brings some twenty libraries of its own, decoders
// and sound servers; linked, they would cost each start of a program 6 ms, and most of the time nobody
// listens.
#pragma once

#include <SDL_mixer.h>

#include <cairn/engine/result.h>

namespace cairn::engine {

/// The functions in use, as SDL_mixer.h names them behind Mix_.
struct MixerLibrary {
    decltype(Mix_AllocateChannels)* AllocateChannels = nullptr;
    decltype(Mix_CloseAudio)* CloseAudio = nullptr;
    decltype(Mix_FreeChunk)* FreeChunk = nullptr;
    decltype(Mix_FreeMusic)* FreeMusic = nullptr;
    decltype(Mix_HaltChannel)* HaltChannel = nullptr;
    decltype(Mix_HaltMusic)* HaltMusic = nullptr;
    decltype(Mix_LoadMUS_RW)* LoadMUS_RW = nullptr;
    decltype(Mix_LoadWAV_RW)* LoadWAV_RW = nullptr;
    decltype(Mix_OpenAudioDevice)* OpenAudioDevice = nullptr;
    decltype(Mix_Pause)* Pause = nullptr;
    decltype(Mix_PauseMusic)* PauseMusic = nullptr;
    decltype(Mix_PlayChannel)* PlayChannel = nullptr;
    decltype(Mix_PlayMusic)* PlayMusic = nullptr;
    decltype(Mix_Playing)* Playing = nullptr;
    decltype(Mix_PlayingMusic)* PlayingMusic = nullptr;
    decltype(Mix_QuickLoad_RAW)* QuickLoad_RAW = nullptr;
    decltype(Mix_RegisterEffect)* RegisterEffect = nullptr;
    decltype(Mix_Resume)* Resume = nullptr;
    decltype(Mix_ResumeMusic)* ResumeMusic = nullptr;
    decltype(Mix_SetPanning)* SetPanning = nullptr;
    decltype(Mix_Volume)* Volume = nullptr;
    decltype(Mix_VolumeMusic)* VolumeMusic = nullptr;
};

/// Takes the library in, once for the whole program, which keeps it. Errors say what is missing.
Result<void> load_mixer();
/// After load_mixer has succeeded.
const MixerLibrary& mixer();

}  // namespace cairn::engine
