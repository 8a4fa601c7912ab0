#ifndef ISR_RECONSTRUCT_EXIT_STATUS_H
#define ISR_RECONSTRUCT_EXIT_STATUS_H

#include <stdexcept>
#include <string>

namespace isr {

// Why the program ended; --help documents the numbers.
enum Exit_status : int
{
  SUCCESS = 0,
  UNEXPECTED = 1,
  BAD_OPTION = 2,
  UNREADABLE_INPUT = 3,
  UNKNOWN_EXTENSION = 4,
  EMPTY_INPUT = 5,
  BROKEN_INPUT = 6,
  NO_SURFACE = 7,
  UNWRITABLE_OUTPUT = 8,
  INTERRUPTED = 130 // what shells report for Ctrl-C
};

// Ends the program with one line on stderr and a status.
class Failure : public std::runtime_error
{
public:
  Failure(Exit_status status, const std::string& message) : std::runtime_error(message), m_status(status) { }

  Exit_status status() const { return m_status; }

private:
  Exit_status m_status;
};

} // namespace isr

#endif // ISR_RECONSTRUCT_EXIT_STATUS_H
