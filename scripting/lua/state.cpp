// The allocator counts every byte and refuses what goes beyond the cap; Lua turns that into a "not enough
// memory" error.
#include "lua/state.h"

#include <cstdio>
#include <cstdlib>
#include <new>

#include "lua/sandbox.h"

namespace cairn::scripting {

State::State(std::size_t memory_cap) {
    memory_.cap = memory_cap;
    lua_ = lua_newstate(&State::allocate, this);
    if (lua_ == nullptr)
        throw std::bad_alloc();  // the machine has no 20 kB left: nothing sensible can follow
    memory_.lua = lua_;
    set_context(nullptr);
    open_safe_libraries(lua_);
}

State::~State() {
    lua_close(lua_);
}

void State::set_context(Context* context) {
    // Coroutines copy the main thread's extra space when they are made, so this must come before any script
    // runs.
    *static_cast<Context**>(lua_getextraspace(lua_)) = context;
}

// Lua calls no message handler for an error of memory, so the place is taken down before it is raised.
// Looking at the stack allocates nothing.
void State::note_place(Memory& memory) {
    memory.place[0] = '\0';
    if (memory.lua == nullptr) return;
    lua_Debug frame;
    for (int level = 0; lua_getstack(memory.lua, level, &frame) != 0; ++level) {
        if (lua_getinfo(memory.lua, "Sl", &frame) == 0 || frame.currentline <= 0) continue;
        std::snprintf(memory.place, sizeof memory.place, "%s:%d", frame.short_src, frame.currentline);
        return;
    }
}

State& State::of(lua_State* L) {
    void* state = nullptr;
    lua_getallocf(L, &state);
    return *static_cast<State*>(state);
}

std::string State::place_of_refusal(lua_State* L) {
    return of(L).memory_.place;
}

const std::string* State::source(std::string_view path) const {
    const auto found = sources_.find(path);
    return found == sources_.end() ? nullptr : &found->second;
}

void* State::allocate(void* state, void* block, std::size_t old_size, std::size_t new_size) {
    Memory& memory = static_cast<State*>(state)->memory_;
    if (block == nullptr) old_size = 0;  // then it tells the kind of object instead
    if (new_size == 0) {
        std::free(block);
        memory.used -= old_size;
        return nullptr;
    }
    const bool is_too_much = new_size > old_size && memory.used - old_size + new_size > memory.cap;
    void* moved = is_too_much ? nullptr : std::realloc(block, new_size);
    if (moved == nullptr) {
        note_place(memory);
        return nullptr;
    }
    memory.used += new_size - old_size;
    if (new_size > old_size) memory.allocated += new_size - old_size;
    return moved;
}

}  // namespace cairn::scripting
