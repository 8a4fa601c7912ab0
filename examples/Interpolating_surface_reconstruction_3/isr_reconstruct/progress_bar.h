#ifndef ISR_RECONSTRUCT_PROGRESS_BAR_H
#define ISR_RECONSTRUCT_PROGRESS_BAR_H

#include <cstddef>
#include <iostream>
#include <string>

#include <unistd.h>

namespace isr {

// A bar on stderr, if stderr is a terminal; the destructor wipes it.
class Progress_bar
{
public:
  explicit Progress_bar(bool is_wanted) : m_is_shown(is_wanted && isatty(STDERR_FILENO) == 1) { }

  Progress_bar(const Progress_bar&) = delete;
  Progress_bar& operator=(const Progress_bar&) = delete;

  ~Progress_bar()
  {
    if (m_is_shown)
      std::cerr << '\r' << std::string(WIDTH + 8, ' ') << '\r' << std::flush;
  }

  void show(double fraction)
  {
    const int percent = static_cast<int>(100. * fraction);
    if (!m_is_shown || percent == m_percent)
      return;
    m_percent = percent;
    const std::size_t filled = static_cast<std::size_t>(fraction * static_cast<double>(WIDTH));
    std::cerr << "\r[" << std::string(filled, '#') << std::string(WIDTH - filled, ' ') << "] " << percent << " %"
              << std::flush;
  }

private:
  static constexpr std::size_t WIDTH = 50; // fits a terminal of 80 columns

  bool m_is_shown;
  int m_percent = -1;
};

} // namespace isr

#endif // ISR_RECONSTRUCT_PROGRESS_BAR_H
