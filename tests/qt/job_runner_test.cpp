// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/jobs/job_runner.h"
#include "tests/qt/patience.h"

#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QStringList>
#include <QTest>
#include <QThread>
#include <atomic>
#include <chrono>
#include <memory>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

namespace mocapress {
namespace {

const auto kNoFailure = [](const QString& message) { FAIL() << message.toStdString(); };

int untilStopped(const Job& job) {
  while (!job.stopRequested()) std::this_thread::sleep_for(std::chrono::microseconds(200));
  return 7;
}

TEST(JobRunner, DeliversTheResultOnItsOwnThread) {
  JobRunner runner;
  const QSignalSpy busy(&runner, &JobRunner::busyChanged);
  QThread* const here = QThread::currentThread();
  QThread* worked_on = nullptr;
  QThread* delivered_on = nullptr;
  int result = 0;
  runner.start(
      [&](const Job&) {
        worked_on = QThread::currentThread();
        return 42;
      },
      [&](int value) {
        delivered_on = QThread::currentThread();
        result = value;
      },
      kNoFailure);
  EXPECT_TRUE(runner.busy());
  ASSERT_TRUE(QTest::qWaitFor([&] { return result != 0; }, kPatience));
  EXPECT_EQ(result, 42);
  EXPECT_NE(worked_on, here);
  EXPECT_EQ(delivered_on, here);
  EXPECT_FALSE(runner.busy());
  EXPECT_EQ(busy.count(), 2);
}

TEST(JobRunner, TurnsWhatTheWorkThrowsIntoAMessage) {
  JobRunner runner;
  QStringList messages;
  const auto fail = [&](const QString& message) { messages << message; };
  const auto no_result = [](int) { FAIL(); };
  runner.start([](const Job&) -> int { throw std::runtime_error("no such file"); }, no_result,
               fail);
  ASSERT_TRUE(QTest::qWaitFor([&] { return messages.size() == 1; }, kPatience));
  EXPECT_EQ(messages.front(), QStringLiteral("no such file"));
  runner.start([](const Job&) -> int { throw 3; }, no_result, fail);
  ASSERT_TRUE(QTest::qWaitFor([&] { return messages.size() == 2; }, kPatience));
  EXPECT_FALSE(messages.back().isEmpty());
}

TEST(JobRunner, StoppedEarlyStillDeliversWhatItHas) {
  JobRunner runner;
  int result = 0;
  runner.start(
      untilStopped, [&](int value) { result = value; }, kNoFailure);
  runner.stopEarly();
  ASSERT_TRUE(QTest::qWaitFor([&] { return result != 0; }, kPatience));
  EXPECT_EQ(result, 7);
}

TEST(JobRunner, DeliversNothingOfAnAbandonedJob) {
  JobRunner runner;
  std::atomic<bool> started = false;
  std::atomic<bool> ended = false;
  bool delivered = false;
  runner.start(
      [&](const Job& job) {
        started = true;
        untilStopped(job);
        job.post([&] { delivered = true; });
        ended = true;
        return 1;
      },
      [&](int) { delivered = true; }, kNoFailure);
  while (!started) std::this_thread::yield();
  runner.abandon();
  EXPECT_FALSE(runner.busy());
  ASSERT_TRUE(QTest::qWaitFor([&] { return ended.load(); }, kPatience));
  bool later = false;  // runs after everything that the first could deliver
  runner.start([](const Job&) { return 2; }, [&](int) { later = true; }, kNoFailure);
  ASSERT_TRUE(QTest::qWaitFor([&] { return later; }, kPatience));
  EXPECT_FALSE(delivered);
}

TEST(JobRunner, FinishRunsTheLastJobEvenIfItHadNotBegun) {
  for (int i = 0; i < 50; ++i) {
    std::atomic<bool> ran = false;
    JobRunner runner;
    runner.start([&](const Job&) { return ran.store(true), 0; }, [](int) {}, kNoFailure);
    runner.finish();
    EXPECT_TRUE(ran);
  }
}

TEST(JobRunner, ANewerJobStopsTheOlderAndMakesItVoid) {
  JobRunner runner;
  std::vector<int> results;
  const auto collect = [&](int value) { results.push_back(value); };
  runner.start(untilStopped, collect, kNoFailure);
  runner.start([](const Job&) { return 2; }, collect, kNoFailure);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !results.empty(); }, kPatience));
  EXPECT_EQ(results, std::vector<int>{2}) << "the older would have come before";
}

TEST(JobRunner, PostsProgressInOrderBeforeTheResult) {
  JobRunner runner;
  std::vector<int> seen;
  runner.start(
      [&seen](const Job& job) {
        for (int i = 0; i < 50; ++i) job.post([&seen, i] { seen.push_back(i); });
        return 50;
      },
      [&](int value) { seen.push_back(value); }, kNoFailure);
  ASSERT_TRUE(QTest::qWaitFor([&] { return seen.size() == 51; }, kPatience));
  for (int i = 0; i <= 50; ++i) EXPECT_EQ(seen[static_cast<std::size_t>(i)], i);
}

TEST(JobRunner, SurvivesManyRestartsAndDeliversTheLast) {
  constexpr int kRestarts = 2000;
  JobRunner runner;
  std::vector<int> results;
  for (int i = 0; i < kRestarts; ++i) {
    runner.start(
        [i](const Job& job) {
          if (i % 3 == 0 && i + 1 < kRestarts) untilStopped(job);
          return i;
        },
        [&](int value) { results.push_back(value); }, kNoFailure);
    if (i % 7 == 0) QCoreApplication::processEvents();
  }
  const auto last_is_there = [&] { return !results.empty() && results.back() == kRestarts - 1; };
  EXPECT_TRUE(QTest::qWaitFor(last_is_there, kPatience));
  EXPECT_TRUE(std::is_sorted(results.begin(), results.end()));
}

TEST(JobRunner, DestructionStopsTheRunningJobAndWaits) {
  std::atomic<bool> ended = false;
  std::atomic<bool> started = false;
  {
    JobRunner runner;
    runner.start(
        [&](const Job& job) {
          started = true;
          untilStopped(job);
          ended = true;
          return 1;
        },
        [](int) { FAIL(); }, kNoFailure);
    while (!started) std::this_thread::yield();
  }
  EXPECT_TRUE(ended);
  QCoreApplication::processEvents();
}

TEST(JobRunner, QuickJobsDoNotWaitBehindLongOnes) {
  std::vector<std::unique_ptr<JobRunner>> paused;
  for (int i = 0; i < 20; ++i) {
    paused.push_back(std::make_unique<JobRunner>(Workers::LongRunning));
    paused.back()->start(
        untilStopped, [](int) {}, kNoFailure);
  }
  JobRunner slider;
  bool answered = false;
  slider.start([](const Job&) { return 1; }, [&](int) { answered = true; }, kNoFailure);
  EXPECT_TRUE(QTest::qWaitFor([&] { return answered; }, kPatience));
}

TEST(JobRunner, AbandonsAJobThatWaitsForAThreadAtOnce) {
  std::vector<std::unique_ptr<JobRunner>> busy;
  for (int i = 0; i < 20; ++i) {
    busy.push_back(std::make_unique<JobRunner>(Workers::Idle));
    busy.back()->start(
        untilStopped, [](int) {}, kNoFailure);
  }
  bool ran = false;
  {
    JobRunner late(Workers::Idle);
    late.start([&](const Job&) { return ran = true; }, [](bool) {}, kNoFailure);
  }
  busy.clear();
  JobRunner next(Workers::Idle);
  next.start([](const Job&) { return 1; }, [](int) {}, kNoFailure);
  next.finish();
  EXPECT_FALSE(ran);
}

TEST(WorkerPool, RunsAllJobsWithinItsThreadLimitAndWaitsForBegunOnes) {
  std::mutex mutex;
  std::set<std::thread::id> threads;
  int done = 0;
  {
    WorkerPool pool(3, LowerPriority::ToTheWindow);
    for (int i = 0; i < 100; ++i)
      pool.run([&] {
        std::this_thread::sleep_for(std::chrono::microseconds(200));
        const std::scoped_lock lock(mutex);
        threads.insert(std::this_thread::get_id());
        ++done;
      });
    const auto all_done = [&] {
      const std::scoped_lock lock(mutex);
      return done == 100;
    };
    EXPECT_TRUE(QTest::qWaitFor(all_done, kPatience));
  }
  EXPECT_LE(threads.size(), 3u);
}

}  // namespace
}  // namespace mocapress
