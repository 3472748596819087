#include "src/accuracy/accuracy.hpp"
#include "src/windows/windows.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace swarf {
namespace {

const std::string page = "docs/reports/accuracy_cost.md";

template <class Point>
std::string describe_error(const Point& p) {
  return fmt::format("{:+.1f} % +- {:.1f} %", 100 * p.error, 100 * p.standard_error);
}

// "" for a run of the whole pass.
std::string describe_windows(const Choice& choice) {
  if (!choice.windows) return "";
  return fmt::format(
      ", in windows, whose mean differs from the whole pass by {} with {:.3g} particles across the chip "
      "(docs/reports/windows.md)",
      describe_error(*choice.windows), choice.windows->chip_rows);
}

std::string ask(double level) { return fmt::format("{:.1f} %", std::ceil(1000 * level - 1e-6) / 10); }

const Choice& nearest(const AccuracyPlan& plan) {
  return *std::min_element(plan.choices.begin(), plan.choices.end(), [&](const Choice& a, const Choice& b) {
    return level_of(a, *plan.chart) < level_of(b, *plan.chart);
  });
}

// What a mean of three runs would reach, if that is less than `level`.
std::string advise_three(const AccuracyPlan& plan, double level) {
  const ChartPoint* best = nullptr;
  for (const ChartPoint& p : plan.chart->points)
    if (p.runs > 1 && p.level && find_obstacle(p, *plan.chart, plan.cut).empty() &&
        level_of(p, *plan.chart) < (best ? level_of(*best, *plan.chart) : level))
      best = &p;
  if (!best) return "";
  return fmt::format(
      " The mean of {} runs, at the uncut chip and a third of a spacing more and less, would be within "
      "{} with {:.3g} particles across the chip, but no single run is.",
      best->runs, ask(level_of(*best, *plan.chart)), best->chip_rows);
}

[[noreturn]] void refuse_asked(const Deck& deck, const AccuracyPlan& plan) {
  const Choice& choice = nearest(plan);
  const ChartPoint& p = *choice.point;
  const double level = level_of(choice, *plan.chart);
  refuse_accuracy(
      deck,
      fmt::format(
          "{:.4g} % cannot be promised: expected at least {}. Of the points measured ({}, {}) the nearest "
          "is \"{}\", {:.3g} particles across the uncut chip: error {}, at most {:.1f} % there and at "
          "finer spacings, and the reference itself is known to {:.1f} %.{} Write accuracy = \"{}\", or "
          "remove the key and choose the settings yourself",
          100 * plan.asked, ask(level), plan.chart->title, page, p.label, p.chip_rows, describe_error(p),
          100 * *p.level, 100 * plan.chart->uncertainty, advise_three(plan, level), ask(level)));
}

std::string explain(const AccuracyPlan& plan) {
  const Choice& choice = plan.choices[plan.picked];
  const ChartPoint& p = *choice.point;
  const auto reaches = [&](const Choice& c) { return level_of(c, *plan.chart) <= plan.asked; };
  const auto good = std::count_if(plan.choices.begin(), plan.choices.end(), reaches);
  std::string text = fmt::format(
      "\"{}\" of the chart of {} ({}), {:.3g} particles across the uncut chip: error of the mean "
      "cutting force {}, at "
      "most {:.1f} % there and at finer spacings, the reference known to {:.1f} %{}; taken {}, "
      "after {:.3g} um of cut over {:.3g} um. The cheapest of the {} of {} choices that keep {:.4g} %",
      p.label, plan.chart->title, page, p.chip_rows, describe_error(p), 100 * *p.level,
      100 * plan.chart->uncertainty, describe_windows(choice), plan.chart->where,
      1e6 * p.run_in * plan.cut.chip, 1e6 * p.measured * plan.cut.chip, good, plan.choices.size(),
      100 * plan.asked);
  if (plan.picked == 0) return text;
  const Choice& before = plan.choices[plan.picked - 1];
  return text +
         fmt::format("; the next cheaper, \"{}\"{}, takes {:.2g} of its time and errs by up to {:.1f} %",
                     before.point->label, before.windows ? " in windows" : "",
                     before.core_seconds / choice.core_seconds, 100 * level_of(before, *plan.chart));
}

} // namespace

double level_of(const ChartPoint& p, const AccuracyChart& chart) {
  return std::max(p.level.value_or(HUGE_VAL), chart.uncertainty);
}

double level_of(const Choice& choice, const AccuracyChart& chart) {
  const double added = choice.windows ? std::abs(choice.windows->error) + choice.windows->standard_error : 0;
  return level_of(*choice.point, chart) + added;
}

AccuracyPlan plan_accuracy(const Deck& deck, const std::vector<AccuracyChart>& charts) {
  AccuracyPlan plan;
  plan.cut = find_cut(deck);
  plan.asked = deck.run.accuracy.value_or(0) / 100;
  for (const AccuracyChart& chart : charts)
    if (chart.tool == deck.tool->kind) plan.chart = &chart;
  if (!plan.chart) refuse_accuracy(deck, "nothing was measured with this tool. Remove this key");
  const int windows = deck.windows ? int(cut_windows(deck, *deck.windows).size()) : 0;
  const bool may_be_whole = !deck.windows || deck.windows->line > 0;
  std::string obstacle = "no settings were measured at several spacings";
  for (const ChartPoint& point : plan.chart->points) {
    if (point.runs > 1 || !point.level) continue;
    const std::string why_not = find_obstacle(point, *plan.chart, plan.cut);
    if (!why_not.empty()) {
      obstacle = why_not;
      continue;
    }
    Deck with = put_settings(deck, plan.cut, point);
    const double core_seconds = predict_core_seconds(with, plan.cut, point);
    if (const WindowsPoint* added =
            windows > 0 ? find_windows(point, *plan.chart, *deck.windows, windows) : nullptr)
      plan.choices.push_back({&point, added, with, core_seconds * effort_in_windows(with)});
    if (!may_be_whole) {
      obstacle = "windows like these were not measured against the whole pass";
      continue;
    }
    with.windows.reset();
    plan.choices.push_back({&point, nullptr, with, core_seconds});
  }
  if (plan.choices.empty())
    refuse_accuracy(deck, "nothing that was measured carries over to this deck: " + obstacle +
                              ". Remove this key and choose the settings yourself");
  std::stable_sort(plan.choices.begin(), plan.choices.end(),
                   [](const Choice& a, const Choice& b) { return a.core_seconds < b.core_seconds; });
  for (int k = int(plan.choices.size()) - 1; k >= 0; --k)
    if (level_of(plan.choices[k], *plan.chart) <= plan.asked) plan.picked = k;
  return plan;
}

Deck planned_deck(const Deck& deck, const AccuracyPlan& plan) {
  if (plan.picked < 0) refuse_asked(deck, plan);
  Deck with = plan.choices[plan.picked].deck;
  AccuracyPick pick;
  pick.asked = *deck.run.accuracy, pick.why = explain(plan);
  for (const KeyChange& change : list_changes(deck, with)) pick.changes.push_back(describe(change));
  with.picked = pick;
  return with;
}

Deck apply_accuracy(const Deck& deck) {
  return deck.run.accuracy ? planned_deck(deck, plan_accuracy(deck)) : deck;
}

} // namespace swarf
