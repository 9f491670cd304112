// One Lua state: its memory, its safe libraries, its scripts' texts, its end. Invariant: scripts in it reach
// nothing but what was put there.
#pragma once

#include <cstddef>
#include <cstdint>
#include <lua.hpp>
#include <map>
#include <memory>
#include <string>
#include <string_view>

namespace cairn::scripting {

struct Context;

/// 256 MiB: ten times what a large 2D game keeps in Lua, and little enough that a runaway script fails before
/// the machine swaps.
inline constexpr std::size_t kDefaultMemoryCap = std::size_t{256} << 20;

class State {
  public:
    explicit State(std::size_t memory_cap = kDefaultMemoryCap);
    ~State();
    State(const State&) = delete;
    State& operator=(const State&) = delete;

    /// The one that L, a coroutine or not, belongs to.
    static State& of(lua_State* L);

    [[nodiscard]] lua_State* get() const { return lua_; }
    [[nodiscard]] std::size_t used_bytes() const { return memory_.used; }
    /// All that was ever asked for, whether it has been freed since or not.
    [[nodiscard]] std::uint64_t allocated_bytes() const { return memory_.allocated; }

    /// Where the script was when it was last refused memory, "main.lua:12"; empty if that is not known. A
    /// coroutine counts as the place that resumed it.
    static std::string place_of_refusal(lua_State* L);

    /// Notes what a script said when it was loaded; its file may say something else by the time an error
    /// asks.
    void keep_source(const std::string& path, std::string text) { sources_[path] = std::move(text); }
    /// Of scripts that were loaded since the last forget_sources(), else null.
    [[nodiscard]] const std::string* source(std::string_view path) const;
    void forget_sources() { sources_.clear(); }

    /// What bindings find with context_of(); null until it is set. Must outlive the state.
    void set_context(Context* context);

  private:
    struct Memory {
        std::size_t used = 0;
        std::size_t cap = 0;
        std::uint64_t allocated = 0;
        lua_State* lua = nullptr;
        char place[LUA_IDSIZE + 16] = "";  ///< of the last refusal
    };
    static void note_place(Memory& memory);
    static void* allocate(void* state, void* block, std::size_t old_size, std::size_t new_size);

    Memory memory_;
    std::map<std::string, std::string, std::less<>> sources_;  ///< by path
    lua_State* lua_ = nullptr;
};

/// The context of the state that L, a coroutine or not, belongs to.
inline Context& context_of(lua_State* L) {
    return **static_cast<Context**>(lua_getextraspace(L));
}

}  // namespace cairn::scripting
