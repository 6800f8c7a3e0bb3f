// A worker that hangs, crashes, aborts or eats memory costs one answer, never the run.

#include "process/supervisor.hpp"

#include "exact/integer.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <optional>
#include <string>
#include <vector>

namespace kov::cli::supervisor_test {
namespace {

volatile unsigned sink = 0;

std::string misbehave(std::string_view job, const Worker::Early& early) {
  early("early " + std::string(job));
  if (job == "hang")
    for (;;)
      sink = sink + 1;
  if (job == "crash") ::raise(SIGSEGV);
  if (job == "abort") std::abort();
  if (job == "flint") flint_abort();
  if (job == "exit") std::exit(5);
  if (job == "new")
    for (std::vector<std::vector<char>> all;;)
      all.emplace_back(std::size_t{64} << 20, 'x');
  if (job == "gmp") { // two gigabytes
    Integer n(2);
    fmpz_pow_ui(n.raw(), n.raw(), 1UL << 34);
  }
  if (job == "interrupt") ::raise(SIGINT);
  if (job == "kill") ::raise(SIGKILL); // what the kernel does where memory is short
  if (job == "term") ::raise(SIGTERM);
  if (job == "big") return std::string(std::size_t{8} << 20, 'b');
  return "done " + std::string(job);
}

TEST(Supervisor, AnswersInOrder) {
  Worker worker(misbehave, {});
  for (int i = 0; i < 100; ++i) {
    const Reply r = worker.ask(std::to_string(i));
    EXPECT_EQ(r.end, Reply::End::answered);
    EXPECT_EQ(r.answer, "done " + std::to_string(i));
  }
  EXPECT_EQ(worker.ask("big").answer.size(), std::size_t{8} << 20);
  EXPECT_EQ(worker.ask(std::string(std::size_t{8} << 20, 'x')).end, Reply::End::answered);
}

TEST(Supervisor, SurvivesEveryDeath) {
  Worker hasty(misbehave, {.seconds = 2, .megabytes = 512});
  Worker patient(misbehave, {.seconds = 60, .megabytes = 512}); // also on a busy machine
  const struct {
    const char* job;
    Reply::End end;
  } table[] = {
      {"hang", Reply::End::timeout},      {"crash", Reply::End::crashed},
      {"abort", Reply::End::crashed},     {"exit", Reply::End::crashed},
      {"flint", Reply::End::crashed},     {"interrupt", Reply::End::interrupted},
      {"kill", Reply::End::killed},       {"term", Reply::End::killed},
#ifndef KOV_SANITIZED // the ceiling needs an address space of its own
      {"new", Reply::End::out_of_memory}, {"gmp", Reply::End::out_of_memory},
#endif
  };
  for (const auto& [job, end] : table) {
    Worker& worker = end == Reply::End::timeout ? hasty : patient;
    const Reply r = worker.ask(job);
    EXPECT_EQ(r.end, end) << job << ": " << r.detail;
    EXPECT_EQ(r.early, "early " + std::string(job));
    EXPECT_EQ(worker.ask("next").answer, "done next") << "after " << job;
  }
}

TEST(Supervisor, TheTimeLimitIsKept) {
  Worker worker(misbehave, {.seconds = 0.2, .megabytes = 0});
  const auto start = std::chrono::steady_clock::now();
  EXPECT_EQ(worker.ask("hang").end, Reply::End::timeout);
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  EXPECT_GE(seconds, 0.2);
  EXPECT_LT(seconds, 5.0);
}

// Several at once: one that hangs or dies holds nobody up, and the messages stay apart.
TEST(Workers, AHardJobHoldsTheOthersUpInNothing) {
  Worker hard(misbehave, {.seconds = 3, .megabytes = 0});
  Worker other(misbehave, {.seconds = 60, .megabytes = 0});
  hard.begin("hang");
  for (const char* job : {"one", "crash", "big", "two"}) {
    other.begin(job);
    std::optional<Reply> reply;
    while (!(reply = other.finished()))
      ASSERT_TRUE(Worker::wait({&hard, &other}, -1));
    EXPECT_EQ(reply->end == Reply::End::crashed, job == std::string("crash"));
    if (job == std::string("two")) {
      EXPECT_EQ(reply->answer, "done two");
    }
  }
  std::optional<Reply> late;
  while (!(late = hard.finished()))
    ASSERT_TRUE(Worker::wait({&hard}, -1));
  EXPECT_EQ(late->end, Reply::End::timeout);
  EXPECT_EQ(late->early, "early hang");
}

} // namespace
} // namespace kov::cli::supervisor_test
