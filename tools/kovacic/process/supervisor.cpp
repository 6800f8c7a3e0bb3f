#include "process/supervisor.hpp"

#include "exact/error.hpp"
#include "exact/flint.hpp"
#include "exact/memory.hpp"
#include "process/interrupt.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <new>
#include <poll.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/uio.h>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>

#ifdef KOV_COVERAGE
extern "C" { // gcov.h says so of C only
#include <gcov.h>
}
#endif

namespace kov::cli {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int exit_out_of_memory = 97;
constexpr int exit_library_abort = 98;

constexpr std::chrono::milliseconds grace{2000}; // for a job that Ctrl-C ends
constexpr std::chrono::milliseconds tick{500};

std::stop_source& asked_to_stop() {
  static std::stop_source source;
  return source;
}

Worker::Waiting& waiting() {
  static Worker::Waiting show;
  return show;
}

// --- out of memory in the child: one way out for C++, GMP and FLINT ----------------------------

void* gmp_take_more(void* p, std::size_t, std::size_t n) { return reallocate(p, n); }
void gmp_give(void* p, std::size_t) { release(p); }

// A worker ends by a signal, which writes no counters of executed lines: tools/coverage has them after
// each job.
void keep_counters() {
#ifdef KOV_COVERAGE
  __gcov_dump();
  __gcov_reset();
#endif
}

void prepare_child(const ProcessLimits& limits) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  (void)asked_to_stop();
  for (const int signal : {SIGINT, SIGTERM})
    ::signal(signal, [](int which) {
      ending_signal = which;
      asked_to_stop().request_stop(); // nothing registers callbacks there
    });
  ::signal(SIGPIPE, SIG_DFL);
  const rlimit no_core{0, 0};
  ::setrlimit(RLIMIT_CORE, &no_core);
  // FLINT announces its aborts on standard output, GMP on standard error: neither is ours.
  const int null = ::open("/dev/null", O_RDWR);
  ::dup2(null, STDIN_FILENO);
  ::dup2(null, STDOUT_FILENO);
#if !defined(__SANITIZE_ADDRESS__) && !defined(KOV_SANITIZED)
  ::dup2(null, STDERR_FILENO);
  if (limits.megabytes > 0) {
    const rlim_t bytes = static_cast<rlim_t>(limits.megabytes) << 20;
    const rlimit ceiling{bytes, bytes};
    ::setrlimit(RLIMIT_AS, &ceiling);
  }
#else
  (void)limits;
#endif
  mp_set_memory_functions(allocate, gmp_take_more, gmp_give);
  flint_set_abort([]() { _exit(exit_library_abort); });
  std::set_new_handler([] { _exit(exit_out_of_memory); });
}

// --- messages: one kind byte, eight bytes of length, the bytes ---------------------------------

constexpr char kind_job = 'j';
constexpr char kind_early = 'e';
constexpr char kind_final = 'f';
constexpr char kind_stopped = 's'; // the same after SIGINT; the child ends then
constexpr char kind_killed = 'k';  // the same after SIGTERM

bool send_all(int fd, std::string_view data) {
  while (!data.empty()) {
    const ssize_t sent = ::send(fd, data.data(), data.size(), MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR && ending_signal == 0) continue;
    if (sent <= 0) return false;
    data.remove_prefix(static_cast<std::size_t>(sent));
  }
  return true;
}

// A short text goes out with its head: each call may wake the other process.
bool send_message(int fd, char kind, std::string_view text) {
  constexpr std::size_t is_short = 1 << 16;
  const std::uint64_t n = text.size();
  std::string head(1 + sizeof n, kind);
  std::memcpy(head.data() + 1, &n, sizeof n);
  if (text.size() <= is_short) return send_all(fd, head.append(text));
  return send_all(fd, head) && send_all(fd, text);
}

enum class Got : std::uint8_t { message, closed, late, interrupted };

// Until when a message is waited for, whether Ctrl-C ends that, and what is called meanwhile.
struct Patience {
  const Clock::time_point* deadline = nullptr;
  bool ends_by_hand = true;
  std::function<void()> meanwhile = {};
};

Got receive_all(int fd, char* data, std::size_t n, const Patience& patience) {
  while (n > 0) {
    const ssize_t there = ::recv(fd, data, n, MSG_DONTWAIT);
    if (there == 0) return Got::closed;
    if (there > 0) {
      data += there;
      n -= static_cast<std::size_t>(there);
      continue;
    }
    if (errno != EAGAIN && errno != EWOULDBLOCK && errno != EINTR) return Got::closed;
    int wait = -1;
    if (patience.deadline != nullptr) {
      const auto left =
          std::chrono::ceil<std::chrono::milliseconds>(*patience.deadline - Clock::now()).count();
      if (left <= 0) return Got::late;
      wait = static_cast<int>(std::min<long>(left, 1000000));
    }
    if (patience.meanwhile) wait = wait < 0 ? tick.count() : std::min<int>(wait, tick.count());
    pollfd p{fd, POLLIN, 0};
    if (::poll(&p, 1, wait) == 0 && patience.meanwhile) patience.meanwhile();
    if (ending_signal != 0 && patience.ends_by_hand) return Got::interrupted;
  }
  return Got::message;
}

Got receive_message(int fd, char& kind, std::string& text, const Patience& patience) {
  char head[9];
  if (const Got g = receive_all(fd, head, sizeof head, patience); g != Got::message) return g;
  kind = head[0];
  std::uint64_t n = 0;
  std::memcpy(&n, head + 1, sizeof n);
  text.resize(n);
  return receive_all(fd, text.data(), n, patience);
}

// Signals that a process brings upon itself; any other one was sent by somebody else.
bool by_own_mistake(int signal) {
  return signal == SIGSEGV || signal == SIGBUS || signal == SIGFPE || signal == SIGILL ||
         signal == SIGABRT || signal == SIGTRAP || signal == SIGSYS;
}

} // namespace

// What the child has said early, in memory that both processes see: most jobs end well and then
// nobody reads it, so that no message is worth its cost.
struct Worker::Notice {
  static constexpr std::size_t capacity = (std::size_t{1} << 16) - sizeof(std::size_t);
  std::atomic<std::size_t> length; // 0: nothing here
  char text[capacity];
};

Worker::Worker(Serve serve, ProcessLimits limits) : serve_(std::move(serve)), limits_(limits) {
  void* shared =
      ::mmap(nullptr, sizeof(Notice), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (shared == MAP_FAILED) throw InternalError("no memory to share with the worker process");
  notice_ = new (shared) Notice;
}

Worker::~Worker() {
  stop();
  ::munmap(notice_, sizeof(Notice));
}

std::stop_token stopped_by_hand() { return asked_to_stop().get_token(); }

void Worker::while_waiting(Waiting show) { waiting() = std::move(show); }

void catch_interrupts() {
  struct sigaction action = {};
  action.sa_handler = [](int signal) { ending_signal = signal; };
  for (const int signal : {SIGINT, SIGTERM})
    ::sigaction(signal, &action, nullptr); // no SA_RESTART: poll must return
}

void Worker::start() {
  int ends[2];
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
    throw InternalError("no channel to the worker process: " + std::string(std::strerror(errno)));
  pid_ = ::fork();
  if (pid_ < 0) {
    ::close(ends[0]);
    ::close(ends[1]);
    throw InternalError("no worker process: " + std::string(std::strerror(errno)));
  }
  if (pid_ == 0) {
    ::close(ends[0]);
    child(ends[1]);
  }
  ::close(ends[1]);
  channel_ = ends[0];
}

void Worker::child(int channel) const {
  prepare_child(limits_);
  char kind = 0;
  std::string job;
  while (receive_message(channel, kind, job, {.ends_by_hand = false}) == Got::message) {
    const std::string answer = serve_(job, [this, channel](std::string_view early) {
      notice_->length = 0;
      if (early.size() > Notice::capacity) {
        if (!send_message(channel, kind_early, early)) _exit(0);
        return;
      }
      std::memcpy(notice_->text, early.data(), early.size());
      notice_->length = early.size();
    });
    keep_counters();
    const bool stopped = asked_to_stop().stop_requested();
    const char end = !stopped ? kind_final : ending_signal == SIGTERM ? kind_killed : kind_stopped;
    if (!send_message(channel, end, answer) || stopped) break;
  }
  _exit(0);
}

void Worker::stop() {
  if (pid_ < 0) return;
  ::close(channel_);
  ::kill(pid_, SIGKILL);
  ::waitpid(pid_, nullptr, 0);
  pid_ = -1;
  channel_ = -1;
}

Reply Worker::ask(std::string_view job) {
  begin(job);
  if (lost_) return *std::exchange(lost_, std::nullopt);
  began_ = Clock::now();
  for (;;)
    if (auto reply = next_message()) {
      if (waiting()) waiting()(-1, "");
      return *std::move(reply);
    }
}

void Worker::begin(std::string_view job) {
  notice_->length = 0;
  early_.clear();
  if (pid_ < 0) start();
  if (!send_message(channel_, kind_job, job)) {
    if (ending_signal == 0) {
      stop(); // it died between two jobs
      start();
    }
    if (ending_signal != 0)
      lost_ = Reply(Reply::End::interrupted);
    else if (!send_message(channel_, kind_job, job))
      lost_ = ended();
  }
  // The job watches its own clock; this one is for library calls that cannot be interrupted.
  const double patience = limits_.seconds + 0.25 + limits_.seconds / 20;
  deadline_ = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                 std::chrono::duration<double>(std::min(patience, 1e9)));
}

std::optional<Reply> Worker::finished() {
  if (lost_) return std::exchange(lost_, std::nullopt);
  pollfd p{channel_, POLLIN, 0};
  const bool late = limits_.seconds > 0 && Clock::now() > deadline_;
  if (::poll(&p, 1, 0) <= 0 && !late) return std::nullopt;
  return next_message();
}

bool Worker::wait(const std::vector<const Worker*>& at_work, int input) {
  std::vector<pollfd> all;
  auto until = Clock::now() + std::chrono::hours(1);
  for (const Worker* w : at_work) {
    if (w->lost_) return true;
    all.push_back({w->channel_, POLLIN, 0});
    if (w->limits_.seconds > 0) until = std::min(until, w->deadline_);
  }
  if (input >= 0) all.push_back({input, POLLIN, 0});
  const auto left = std::chrono::ceil<std::chrono::milliseconds>(until - Clock::now()).count();
  ::poll(all.data(), all.size(), static_cast<int>(std::max<long>(left, 0)));
  return ending_signal == 0;
}

// Waits for the next message of the job; unset if it was an early one.
std::optional<Reply> Worker::next_message() {
  char kind = 0;
  std::string text;
  Reply reply;
  Patience patience{.deadline = limits_.seconds > 0 ? &deadline_ : nullptr};
  if (waiting() && began_)
    patience.meanwhile = [this] {
      waiting()(std::chrono::duration<double>(Clock::now() - *began_).count(), early());
    };
  switch (receive_message(channel_, kind, text, patience)) {
  case Got::message:
    if (kind == kind_early) {
      early_ = std::move(text);
      return std::nullopt;
    }
    reply.answer = std::move(text);
    if (kind == kind_final) return reply;
    stop();
    reply.end = Reply::End::interrupted;
    if (kind == kind_killed && ending_signal == 0) { // somebody ended the child alone
      reply.end = Reply::End::killed;
      reply.answer.clear();
      reply.detail = "signal " + std::to_string(SIGTERM) + " (" + ::strsignal(SIGTERM) + ")";
    }
    break;
  case Got::closed:
    reply = ended();
    break;
  case Got::late:
    stop();
    reply.end = Reply::End::timeout;
    break;
  case Got::interrupted:
    reply.answer = last_words();
    stop();
    reply.end = Reply::End::interrupted;
    break;
  }
  reply.early = early();
  return reply;
}

std::string Worker::early() const {
  return notice_->length > 0
             ? std::string(notice_->text, std::min(notice_->length.load(), Notice::capacity))
             : early_;
}

// After Ctrl-C: what the job has when it ends by itself; "" if it does not.
std::string Worker::last_words() {
  ::kill(pid_, SIGINT); // a terminal has sent it to both
  const Clock::time_point end = Clock::now() + grace;
  char kind = kind_early;
  std::string text;
  while (receive_message(channel_, kind, text, {.deadline = &end, .ends_by_hand = false}) ==
         Got::message) {
    if (kind != kind_early) return text;
    early_ = std::move(text);
  }
  return "";
}

// The child is gone: why?
Reply Worker::ended() {
  int status = 0;
  ::waitpid(pid_, &status, 0);
  ::close(channel_);
  pid_ = -1;
  channel_ = -1;
  Reply reply(Reply::End::crashed);
  if (ending_signal != 0 || (WIFSIGNALED(status) && WTERMSIG(status) == SIGINT))
    reply.end = Reply::End::interrupted;
  else if (WIFEXITED(status) && WEXITSTATUS(status) == exit_out_of_memory)
    reply.end = Reply::End::out_of_memory;
  else if (WIFEXITED(status) && WEXITSTATUS(status) == exit_library_abort)
    reply.detail = "a library gave up (flint_abort)";
  else if (WIFSIGNALED(status)) {
    reply.detail =
        "signal " + std::to_string(WTERMSIG(status)) + " (" + ::strsignal(WTERMSIG(status)) + ")";
    if (!by_own_mistake(WTERMSIG(status))) reply.end = Reply::End::killed;
  } else
    reply.detail = "exit status " + std::to_string(WEXITSTATUS(status));
  return reply;
}

} // namespace kov::cli
