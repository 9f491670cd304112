// The threads of a game engine, lent to a world: two functions and what they need, as plain data.
#pragma once

namespace cairn::physics {

/// How a world runs its loops on threads that the host owns. With `WorldDef::tasks` a world makes no threads
/// of its own. The results of a step are the same bits, however many of the tasks run, when, and on which
/// thread.
///
/// A task lives about as long as the step and is busy all the while: it takes parts of the world's loops as
/// they come, and waits in between without giving its thread back.
struct TaskSystem {
    /// Call it with the data of `enqueue`, and once with each index from 0 up to, and without, count. It
    /// throws nothing.
    using Task = void (*)(void* data, int index);

    /// Given to both functions. It must live as long as the world.
    void* context = nullptr;

    /// Starts count tasks and comes back without waiting for them; what it gives is handed to `wait`. Tasks
    /// that start late, or not before `wait`, cost speed and nothing else. Called at most once per step, by
    /// the thread that steps the world, which works along.
    void* (*enqueue)(void* context, Task task, void* data, int count) = nullptr;

    /// Comes back when the tasks of that group have ended. Called at the end of the step; none of them has
    /// anything left to do then.
    void (*wait)(void* context, void* group) = nullptr;
};

}  // namespace cairn::physics
