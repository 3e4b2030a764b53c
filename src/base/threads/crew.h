// Threads that wait for work, for as long as they live.
#pragma once

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace tread {

class Crew {
public:
    // Besides the caller's own thread.
    explicit Crew(int helpers) {
        for (int i = 0; i < helpers; ++i) threads_.emplace_back([this] { wait(); });
    }
    ~Crew() {
        {
            const std::lock_guard lock(mutex_);
            ends_ = true;
        }
        begins_.notify_all();
        for (std::thread& thread : threads_) thread.join();
    }
    Crew(const Crew&) = delete;
    Crew& operator=(const Crew&) = delete;

    // Does `work` for each number below `count`, in no order; returns when all is done and throws what was thrown
    // first. A thread takes so many numbers `at_once`: few meetings of threads for short work, even shares for long.
    void each(std::size_t count, const std::function<void(std::size_t)>& work, std::size_t at_once = 8) {
        {
            const std::lock_guard lock(mutex_);
            work_ = &work;
            count_ = count;
            at_once_ = at_once;
            next_ = 0;
            busy_ = threads_.size();
            ++round_;
        }
        begins_.notify_all();
        help();
        std::unique_lock lock(mutex_);
        done_.wait(lock, [this] { return busy_ == 0; });
        if (const auto thrown = std::exchange(thrown_, nullptr)) std::rethrow_exception(thrown);
    }

private:
    void wait() {
        std::size_t seen = 0;
        while (true) {
            {
                std::unique_lock lock(mutex_);
                begins_.wait(lock, [&] { return ends_ || round_ != seen; });
                if (ends_) return;
                seen = round_;
            }
            help();
            const std::lock_guard lock(mutex_);
            if (--busy_ == 0) done_.notify_one();
        }
    }

    void help() {
        for (std::size_t first = next_.fetch_add(at_once_); first < count_; first = next_.fetch_add(at_once_)) {
            for (std::size_t i = first; i < std::min(first + at_once_, count_); ++i) {
                try {
                    (*work_)(i);
                } catch (...) {
                    const std::lock_guard lock(mutex_);
                    if (!thrown_) thrown_ = std::current_exception();
                }
            }
        }
    }

    std::mutex mutex_;
    std::condition_variable begins_, done_;
    const std::function<void(std::size_t)>* work_ = nullptr;
    std::size_t count_ = 0, at_once_ = 1, busy_ = 0, round_ = 0;
    std::atomic<std::size_t> next_{0};
    std::exception_ptr thrown_;
    bool ends_ = false;
    std::vector<std::thread> threads_;  // last: they begin when all else is there
};

}  // namespace tread
