// Threads that do parts of a job side by side with the caller.
// Invariant: a job's parts are each done once, all before `run` returns; which thread does which part is left
// to chance, so parts must not depend on one another.
#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace cairn::engine {

class BandWorkers {
  public:
    /// With so many threads in all, the caller's among them; they start with the first job.
    explicit BandWorkers(int threads) : threads_(threads) {}
    ~BandWorkers();
    BandWorkers(const BandWorkers&) = delete;
    BandWorkers& operator=(const BandWorkers&) = delete;

    [[nodiscard]] int threads() const { return threads_; }
    /// Calls part(0) to part(count - 1).
    void run(int count, const std::function<void(int)>& part);

    /// As many as help with a picture on this machine: its processors, but no more than four.
    static int threads_of_machine();

  private:
    void start();
    void work();
    /// Does parts until none is left; with the lock held, but not while doing them.
    void do_parts(std::unique_lock<std::mutex>& lock);

    int threads_;
    std::vector<std::thread> helpers_;
    std::mutex mutex_;  ///< of all below
    std::condition_variable there_is_work_;
    std::condition_variable is_done_;
    const std::function<void(int)>* part_ = nullptr;
    int next_ = 0;
    int count_ = 0;
    int unfinished_ = 0;
    bool ends_ = false;
};

}  // namespace cairn::engine
