// The allocator counts every byte and refuses what goes beyond the cap; Lua turns that into a "not enough
// memory" error.
#include "lua/state.h"

#include <cstdlib>
#include <new>

#include "lua/sandbox.h"

namespace cairn::scripting {

State::State(std::size_t memory_cap) {
    memory_.cap = memory_cap;
    lua_ = lua_newstate(&State::allocate, &memory_);
    if (lua_ == nullptr)
        throw std::bad_alloc();  // the machine has no 20 kB left: nothing sensible can follow
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

void* State::allocate(void* memory_pointer, void* block, std::size_t old_size, std::size_t new_size) {
    auto& memory = *static_cast<Memory*>(memory_pointer);
    if (block == nullptr) old_size = 0;  // then it tells the kind of object instead
    if (new_size == 0) {
        std::free(block);
        memory.used -= old_size;
        return nullptr;
    }
    if (new_size > old_size && memory.used - old_size + new_size > memory.cap) return nullptr;
    void* moved = std::realloc(block, new_size);
    if (moved == nullptr) return nullptr;
    memory.used += new_size - old_size;
    if (new_size > old_size) memory.allocated += new_size - old_size;
    return moved;
}

}  // namespace cairn::scripting
