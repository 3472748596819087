#include "src/output/history.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace swarf {
namespace {

// Second-order Butterworth by the bilinear transform with prewarping (Oppenheim & Schafer, Discrete-Time
// Signal Processing, ch. 7), direct form II transposed, from rest.
struct Biquad {
  double b0, b1, b2, a1, a2;

  explicit Biquad(double frequency_times_step) {
    const double w = std::tan(M_PI * frequency_times_step);
    const double a0 = 1 + std::sqrt(2.0) * w + w * w;
    b0 = w * w / a0, b1 = 2 * b0, b2 = b0;
    a1 = 2 * (w * w - 1) / a0, a2 = (1 - std::sqrt(2.0) * w + w * w) / a0;
  }
  void run(std::vector<double>& x) const {
    double s1 = 0, s2 = 0;
    for (double& value : x) {
      const double in = value;
      value = b0 * in + s1;
      s1 = b1 * in - a1 * value + s2;
      s2 = b2 * in - a2 * value;
    }
  }
};

double interpolate(const std::vector<double>& t, const std::vector<double>& v, double at, std::size_t& k) {
  while (k + 2 < t.size() && t[k + 1] < at) ++k;
  const double s = (at - t[k]) / (t[k + 1] - t[k]);
  return v[k] + s * (v[k + 1] - v[k]);
}

} // namespace

std::vector<double> low_pass(const std::vector<double>& time, const std::vector<double>& value,
                             double frequency) {
  const std::size_t n = time.size();
  if (value.size() != n) throw std::invalid_argument("low_pass: as many times as values are needed");
  for (std::size_t i = 1; i < n; ++i)
    if (!(time[i] > time[i - 1])) throw std::invalid_argument("low_pass: the times must increase");
  if (n < 3) return value;

  const double step = (time.back() - time.front()) / double(n - 1);
  if (!(frequency > 0) || frequency * step >= 0.5) return value;
  std::vector<double> even_time(n), even(n);
  for (std::size_t i = 0, k = 0; i < n; ++i) {
    even_time[i] = i + 1 < n ? time.front() + double(i) * step : time.back();
    even[i] = interpolate(time, value, even_time[i], k);
  }

  // The filter passes straight lines: without the one through both ends it starts and stops at rest.
  const double first = even.front(), slope = (even.back() - first) / double(n - 1);
  for (std::size_t i = 0; i < n; ++i) even[i] -= first + slope * double(i);

  // Long enough for the filter's start to die out (2.5 periods: e^-11), as far as the record reaches.
  const auto pad = std::min(n - 1, static_cast<std::size_t>(std::ceil(2.5 / (frequency * step))));
  std::vector<double> x;
  x.reserve(n + 2 * pad);
  for (std::size_t i = pad; i > 0; --i) x.push_back(-even[i]);
  x.insert(x.end(), even.begin(), even.end());
  for (std::size_t i = 1; i <= pad; ++i) x.push_back(-even[n - 1 - i]);

  const Biquad filter(frequency * step);
  filter.run(x);
  std::reverse(x.begin(), x.end());
  filter.run(x);
  std::reverse(x.begin(), x.end());

  for (std::size_t i = 0; i < n; ++i) even[i] = x[pad + i] + first + slope * double(i);
  std::vector<double> out(n);
  for (std::size_t i = 0, k = 0; i < n; ++i) out[i] = interpolate(even_time, even, time[i], k);
  return out;
}

double default_filter_frequency(const std::vector<double>& time) {
  return time.size() < 2 ? 0 : 40 / (time.back() - time.front());
}

} // namespace swarf
