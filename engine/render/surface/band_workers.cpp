// A job has a handful of parts of a millisecond each, so one lock for all is cheap enough.
#include "render/surface/band_workers.h"

#include <algorithm>

namespace cairn::engine {

BandWorkers::~BandWorkers() {
    {
        const std::lock_guard lock(mutex_);
        ends_ = true;
    }
    there_is_work_.notify_all();
    for (std::thread& helper : helpers_) helper.join();
}

int BandWorkers::threads_of_machine() {
    return static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1u, 4u));
}

void BandWorkers::start() {
    while (static_cast<int>(helpers_.size()) < threads_ - 1) helpers_.emplace_back([this] { work(); });
}

void BandWorkers::run(int count, const std::function<void(int)>& part) {
    if (threads_ <= 1 || count <= 1) {
        for (int i = 0; i < count; ++i) part(i);
        return;
    }
    start();
    std::unique_lock lock(mutex_);
    part_ = &part;
    next_ = 0;
    count_ = unfinished_ = count;
    there_is_work_.notify_all();
    do_parts(lock);
    is_done_.wait(lock, [this] { return unfinished_ == 0; });
}

void BandWorkers::work() {
    std::unique_lock lock(mutex_);
    while (!ends_) {
        do_parts(lock);
        there_is_work_.wait(lock, [this] { return ends_ || next_ < count_; });
    }
}

void BandWorkers::do_parts(std::unique_lock<std::mutex>& lock) {
    while (next_ < count_) {
        const int mine = next_++;
        const std::function<void(int)>& part = *part_;
        lock.unlock();
        part(mine);
        lock.lock();
        if (--unfinished_ == 0) is_done_.notify_one();
    }
}

}  // namespace cairn::engine
