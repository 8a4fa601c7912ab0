#ifndef ISR_RECONSTRUCT_INTERRUPTION_H
#define ISR_RECONSTRUCT_INTERRUPTION_H

#include "exit_status.h"

#include <atomic>
#include <csignal>
#include <fstream>

namespace isr {

namespace internal {

inline std::atomic<bool> interrupted{ false };
static_assert(std::atomic<bool>::is_always_lock_free, "set by a signal handler");

extern "C" inline void on_interruption(int) { interrupted.store(true); }

} // namespace internal

// From here on Ctrl-C and a request to terminate only raise a flag, so that temporary files are
// removed; a second one ends the process at once.
inline void catch_interruptions()
{
  struct sigaction action = {};
  action.sa_handler = internal::on_interruption;
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  sigemptyset(&action.sa_mask);
  for (int signal : { SIGINT, SIGTERM, SIGHUP })
    sigaction(signal, &action, nullptr);
}

inline bool is_interrupted() { return internal::interrupted.load(); }

inline void throw_if_interrupted()
{
  if (is_interrupted())
    throw Failure(INTERRUPTED, "interrupted");
}

// A file buffer that ends when the program is interrupted: CGAL's readers and writers offer no
// other way to stop them.
class Interruptible_filebuf : public std::filebuf
{
protected:
  int_type underflow() override { return is_interrupted() ? traits_type::eof() : std::filebuf::underflow(); }

  int_type overflow(int_type c) override { return is_interrupted() ? traits_type::eof() : std::filebuf::overflow(c); }
};

} // namespace isr

#endif // ISR_RECONSTRUCT_INTERRUPTION_H
