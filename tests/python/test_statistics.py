# SPDX-License-Identifier: BSD-3-Clause
"""Every estimator against a second way to its number: closed forms, enumeration, published data, simulation."""

import itertools
import math
from types import SimpleNamespace

import infer
import numpy as np
import pandas
import pytest
from inference import multiplicity, paired, profiles, success, survival, trends
from scipy import stats

EXACT = 1e-9
CAMPAIGNS = 1000
# 99.9 % of binomial counts lie within this many standard deviations.
DEVIATIONS = 3.3


def binomial_error(share, count=CAMPAIGNS):
    return DEVIATIONS * math.sqrt(share * (1.0 - share) / count)


class TestSuccess:
    @pytest.mark.parametrize("runs", [20, 100, 1000])
    def test_clopper_pearson_of_only_successes(self, runs):
        # The lower bound p solves p^n = alpha / 2.
        low, high = success.interval(runs, runs, method="clopper_pearson")
        assert low == pytest.approx(0.025 ** (1.0 / runs), abs=EXACT)
        assert high == 1.0

    def test_clopper_pearson_holds_the_binomial_tails(self):
        low, high = success.interval(7, 50, method="clopper_pearson")
        assert stats.binom.sf(6, 50, low) == pytest.approx(0.025, abs=EXACT)
        assert stats.binom.cdf(7, 50, high) == pytest.approx(0.025, abs=EXACT)

    def test_wilson_solves_its_quadratic_equation(self):
        # |k/n - p| = z sqrt(p (1 - p) / n)
        z = stats.norm.ppf(0.975)
        for bound in success.interval(33, 40):
            assert abs(33 / 40 - bound) == pytest.approx(z * math.sqrt(bound * (1 - bound) / 40), abs=EXACT)

    def test_published_sample_sizes(self):
        # Runs per planner at 80 % power (normal approximation, unpooled): the usual textbook figures.
        z = stats.norm.ppf(0.975) + stats.norm.ppf(0.8)
        for one, other, published in [(0.90, 0.95, 434), (0.95, 0.99, 284), (0.8, 0.9, 199)]:
            textbook = z**2 * (one * (1 - one) + other * (1 - other)) / (one - other) ** 2
            assert success.needed_runs(one, other) == pytest.approx(published, rel=0.02)
            assert success.needed_runs(one, other) == pytest.approx(textbook, rel=0.04)

    def test_the_detectable_difference_has_the_power_asked_for(self):
        loss = success.detectable_difference(0.95, 200)
        assert success.power(0.95, 0.95 - loss, 200) == pytest.approx(0.8, abs=EXACT)
        assert math.isnan(success.detectable_difference(0.05, 5))

    def test_callers_mistakes(self):
        with pytest.raises(ValueError):
            success.interval(3, 2)
        with pytest.raises(ValueError):
            success.needed_runs(0.5, 0.5)


# Remission of leukaemia, weeks (Freireich et al., Blood 21, 1963): 6-MP with its censored times, and placebo.
TREATED = [6, 6, 6, 7, 10, 13, 16, 22, 23, 6, 9, 10, 11, 17, 19, 20, 25, 32, 32, 34, 35]
TREATED_SEEN = [True] * 9 + [False] * 12
PLACEBO = [1, 1, 2, 2, 3, 4, 4, 5, 5, 8, 8, 8, 8, 11, 11, 12, 12, 15, 17, 22, 23]


def leukaemia():
    return pandas.DataFrame({"time": TREATED + PLACEBO, "solved": TREATED_SEEN + [True] * 21}), ["6-MP"] * 21 + ["no"] * 21


class TestSurvival:
    def test_kaplan_meier_of_published_data(self):
        table, _ = leukaemia()
        curve = survival.kaplan_meier(table[:21])
        expected = np.cumprod([18 / 21, 16 / 17, 14 / 15, 11 / 12, 10 / 11, 6 / 7, 5 / 6])
        assert list(curve.surv_times) == [6, 7, 10, 13, 16, 22, 23]
        assert curve.surv_prob == pytest.approx(expected, abs=EXACT)
        assert survival.median(table[:21]).value == 23
        assert survival.median(table[21:]).value == 8

    def test_log_rank_of_published_data(self):
        # Observed less expected, and the hypergeometric variance, summed over times; R's survdiff prints 16.8.
        table, group = leukaemia()
        treated = np.array(group) == "6-MP"
        surplus = variance = 0.0
        for time in sorted(set(table["time"][table["solved"]])):
            at_risk = table["time"] >= time
            events = (table["time"] == time) & table["solved"]
            n, n1, d, d1 = at_risk.sum(), (at_risk & treated).sum(), events.sum(), (events & treated).sum()
            surplus += d1 - d * n1 / n
            if n > 1:
                variance += d * n1 / n * (1 - n1 / n) * (n - d) / (n - 1)
        statistic, probability = survival.log_rank(table, group, ["all"] * 42)
        assert statistic == pytest.approx(surplus**2 / variance, abs=EXACT)
        assert statistic == pytest.approx(16.79, abs=0.005)
        assert probability == pytest.approx(stats.chi2.sf(statistic, 1), abs=EXACT)

    def test_restricted_mean_is_the_area_under_the_curve(self):
        # Without censoring before the limit: the mean of what is cut off there, and its standard error (divisor n).
        table, _ = leukaemia()
        limit = 10.0
        cut = np.minimum(PLACEBO, limit)
        placebo = survival.observations(
            pandas.DataFrame({"cpu": PLACEBO, "solved": True, "outcome": "solved"}).astype({"cpu": float}), limit
        )
        estimate = survival.restricted_mean(placebo, limit)
        assert estimate.value == pytest.approx(cut.mean(), abs=EXACT)
        error = np.std(cut) / math.sqrt(len(cut))
        assert estimate.high - estimate.value == pytest.approx(stats.norm.ppf(0.975) * error, abs=EXACT)
        # With censoring: by hand from the products above.
        areas = np.array([6, 1, 3, 3, 3, 6, 1, 7]) * np.concatenate(
            [[1], np.cumprod([18 / 21, 16 / 17, 14 / 15, 11 / 12, 10 / 11, 6 / 7, 5 / 6])]
        )
        assert survival.restricted_mean(table[:21], 30.0).value == pytest.approx(areas.sum(), abs=EXACT)

    def test_failures_never_happen_and_timeouts_are_censored(self):
        runs = pandas.DataFrame(
            {
                "cpu": [1.0, 2.0, 0.1, 3.0, 9.0],
                "solved": [True, True, False, False, True],
                "outcome": ["solved", "solved", "no_solution", "timeout", "solved"],
            }
        )
        table = survival.observations(runs, 5.0)
        assert list(table["time"]) == [1.0, 2.0, 5.0, 3.0, 5.0]
        assert list(table["solved"]) == [True, True, False, False, False]
        # A failure at 0.1 s must not make the others look better, as it would if it were censored.
        assert survival.kaplan_meier(table).surv_prob == pytest.approx([4 / 5, 3 / 5], abs=EXACT)
        assert survival.median(table).value == np.inf

    def test_nothing_solved(self):
        runs = pandas.DataFrame({"cpu": [1.0, 1.0], "solved": [False, False], "outcome": ["timeout", "crash"]})
        table = survival.observations(runs, 1.0)
        assert survival.restricted_mean(table, 1.0) == survival.Estimate(1.0, 1.0, 1.0)
        assert survival.median(table).value == np.inf
        with pytest.raises(ValueError):
            survival.observations(runs, 0.0)


class TestPaired:
    def test_mcnemar_is_a_fair_coin(self):
        for first, second in itertools.product(range(7), range(7)):
            n, least = first + second, min(first, second)
            tail = sum(math.comb(n, k) for k in range(least + 1)) / 2.0**n
            assert paired.success_probability(first, second) == pytest.approx(min(1.0, 2 * tail), abs=EXACT)

    def test_wilcoxon_by_enumeration_of_signs(self):
        ratios = np.array([1.3, 0.9, 2.5, 1.7, 1.05, 3.1, 0.7])
        ranks = stats.rankdata(np.abs(np.log(ratios)))
        seen = min(ranks[ratios > 1].sum(), ranks[ratios < 1].sum())
        sums = [np.dot(signs, ranks) for signs in itertools.product([0, 1], repeat=7)]
        expected = np.mean([min(s, 28 - s) <= seen for s in sums])
        assert paired.time_probability(np.ones(7), ratios) == pytest.approx(expected, abs=EXACT)
        assert paired.time_probability([1.0, 2.0], [1.0, 2.0]) == 1.0

    def table(self):
        rows = []
        for instance in range(12):
            for run in range(3):
                rows.append((instance, "a", True, 1.0 + instance))
                rows.append((instance, "b", instance % 4 != 0 or run == 0, 2.0 + 2.0 * instance))
        return pandas.DataFrame(rows, columns=["instance", "planner", "solved", "cpu"])

    def test_comparison_counts_instances_and_not_runs(self):
        found = paired.compare(self.table(), "a", "b", 100.0, np.random.default_rng(1))
        assert (found.instances, found.only_first, found.only_second) == (12, 3, 0)
        # Of instances 0, 4, 8 one run solves and two count with the limit.
        second = [(2.0 + 2.0 * i + (200.0 if i % 4 == 0 else 2 * (2.0 + 2.0 * i))) / 3.0 for i in range(12)]
        assert found.ratio == pytest.approx(np.mean(second) / np.mean(1.0 + np.arange(12)), abs=EXACT)
        assert found.ratio_low < found.ratio < found.ratio_high
        assert found.success_p == pytest.approx(0.25, abs=EXACT)
        assert found == paired.compare(self.table(), "a", "b", 100.0, np.random.default_rng(1))

    def test_comparison_of_nothing(self):
        with pytest.raises(ValueError):
            paired.compare(self.table(), "a", "c", 100.0, np.random.default_rng(1))

    def test_bootstrap_is_scipys_and_knows_when_there_is_nothing_to_say(self):
        first, second = np.array([1.0, 2.0, 3.0, 5.0]), np.array([2.0, 3.0, 9.0, 4.0])
        result = stats.bootstrap(
            (first, second),
            lambda a, b: math.log(np.mean(b)) - math.log(np.mean(a)),
            paired=True,
            vectorized=False,
            n_resamples=999,
            random_state=np.random.default_rng(3),
        )
        ratio, low, high = paired.mean_ratio(first, second, np.random.default_rng(3), resamples=999)
        assert ratio == pytest.approx(18 / 11, abs=EXACT)
        assert [low, high] == pytest.approx(np.exp(list(result.confidence_interval)), abs=EXACT)
        assert math.isnan(paired.mean_ratio([1.0, 2.0], [2.0, 4.0], np.random.default_rng(3))[1])


class TestMultiplicity:
    def test_textbook_example(self):
        values = [0.01, 0.04, math.nan, 0.03, 0.005]
        assert multiplicity.holm(values) == pytest.approx([0.03, 0.06, math.nan, 0.06, 0.02], abs=EXACT, nan_ok=True)
        expected = [0.02, 0.04, math.nan, 0.04, 0.02]
        assert multiplicity.benjamini_hochberg(values) == pytest.approx(expected, abs=EXACT, nan_ok=True)
        assert list(multiplicity.holm([])) == []


class TestProfiles:
    def test_shares_counted_by_hand(self):
        costs = pandas.DataFrame({"a": [1.0, 2.0, np.inf, np.inf], "b": [2.0, 1.0, 3.0, np.nan]})
        ratios = profiles.performance_ratios(costs)
        assert ratios.to_numpy().tolist() == [[1, 2], [2, 1], [np.inf, 1], [np.inf, np.inf]]
        assert profiles.profile(ratios, [1.0, 2.0]).to_numpy().tolist() == [[0.25, 0.5], [0.5, 0.75]]
        assert profiles.profile(costs, [0.5, 1.0, 3.0])["b"].tolist() == [0.0, 0.25, 0.75]


def simulated_phase(generator, instances=40):
    """Half of the runs are solved at the half width 10^(-3 + dof / 10)."""
    rows = [(10.0**w, dof, i) for w in (-5, -4, -3, -2, -1) for dof in (3, 6, 12) for i in range(instances)]
    width, dof, _ = (np.array(column, float) for column in zip(*rows))
    logit = 2.0 * (np.log10(width) + 3.0 - dof / 10.0)
    solved = generator.random(len(rows)) < 1.0 / (1.0 + np.exp(-logit))
    return solved, width, dof, np.arange(len(rows))


class TestTrends:
    def test_the_line_is_where_it_was_put(self):
        # 95 % bands hold the truth in 95 % of campaigns; 200 of them, so that the test is quick.
        generator = np.random.default_rng(5)
        covered = 0
        for _ in range(200):
            line = trends.phase_line(*simulated_phase(generator))
            assert line.failure == ""
            middle, low, high = line.half_width([6.0])
            covered += low[0] < 10.0 ** (-3.0 + 0.6) < high[0]
        assert abs(covered / 200 - 0.95) < binomial_error(0.95, 200)

    def test_the_band_is_the_delta_methods(self):
        line = trends.phase_line(*simulated_phase(np.random.default_rng(2)))
        dof, h = 12.0, 1e-6

        def place(coefficients):
            return -(coefficients[0] + coefficients[2] * dof) / coefficients[1]

        steps = h * np.eye(3)
        gradient = [(place(line.coefficients + s) - place(line.coefficients - s)) / (2 * h) for s in steps]
        half = stats.norm.ppf(0.975) * math.sqrt(gradient @ line.covariance @ gradient)
        _, low, high = line.half_width(dof)
        assert math.log10(high / low) == pytest.approx(2 * half, rel=1e-6)

    def test_named_failures(self):
        width, dof = [1e-3, 1e-2, 1e-1, 1.0] * 5, [3, 6, 3, 6] * 5
        assert trends.phase_line([True] * 20, width, dof, range(20)).failure == "all_alike"
        assert trends.phase_line(np.array(width) > 0.05, width, dof, range(20)).failure == "separated"
        solved, width, dof, instance = simulated_phase(np.random.default_rng(1))
        assert trends.phase_line(~solved, width, dof, instance).failure == "no_trend"

    def test_slope_of_a_power_law(self):
        width = np.repeat([1e-4, 1e-3, 1e-2], 30)
        noise = np.random.default_rng(3).normal(0.0, 0.3, 90)
        slope = trends.cost_slope(width**-0.4 * 10.0**noise, width, np.arange(90))
        x, y = np.log10(width), -0.4 * np.log10(width) + noise
        assert slope.exponent == pytest.approx(np.polyfit(x, y, 1)[0], abs=EXACT)
        assert slope.low < -0.4 < slope.high
        costs = np.where(np.arange(90) % 9 == 0, np.nan, width**-0.4)
        assert trends.cost_slope(costs, width, np.arange(90)).exponent == pytest.approx(-0.4, abs=EXACT)
        assert trends.cost_slope(costs, width, np.arange(90)).unsolved == 10
        with pytest.raises(ValueError):
            trends.cost_slope([1.0, 2.0], [0.1, 0.1], [1, 2])


def simulated_times(generator, planners, instances, effect=0.0, spread=0.5):
    """Lognormal times: instances differ by a factor of ten or so, runs on one by less. The last planner's are longer by
    `effect` (natural logarithm)."""
    hardness = generator.normal(0.0, 1.5, (1, instances))
    times = np.exp(hardness + generator.normal(0.0, spread, (planners, instances)))
    times[-1] *= math.exp(effect)
    return times


class TestCampaigns:
    """The tests keep what they promise, over whole simulated campaigns."""

    def test_a_planner_does_not_differ_from_itself(self):
        generator = np.random.default_rng(8)
        found = 0
        for _ in range(CAMPAIGNS):
            first, second = simulated_times(generator, 2, 60)
            found += paired.time_probability(first, second) < 0.05
        assert abs(found / CAMPAIGNS - 0.05) < binomial_error(0.05)

    def test_a_planner_does_not_solve_more_than_itself(self):
        # An exact test of a discrete number keeps below its level, and does not reach it.
        generator = np.random.default_rng(9)
        found = 0
        for _ in range(CAMPAIGNS):
            first, second = generator.random((2, 60)) < 0.7
            found += paired.success_probability((first & ~second).sum(), (~first & second).sum()) < 0.05
        assert found / CAMPAIGNS < 0.05 + binomial_error(0.05)
        assert found > 0

    def test_log_rank_of_a_planner_and_itself(self):
        generator = np.random.default_rng(10)
        planner, instance = np.repeat([0, 1], 48), np.tile(np.repeat(np.arange(6), 8), 2)
        found = 0
        for _ in range(CAMPAIGNS):
            times = np.exp(np.tile(np.repeat(generator.normal(0.0, 1.5, 6), 8), 2) + generator.normal(0.0, 0.5, 96))
            table = pandas.DataFrame({"time": np.minimum(times, 3.0), "solved": times < 3.0})
            found += survival.log_rank(table, planner, instance)[1] < 0.05
        assert abs(found / CAMPAIGNS - 0.05) < binomial_error(0.05)

    def test_bootstrap_intervals_hold_the_truth(self):
        generator = np.random.default_rng(11)
        held = 0
        for _ in range(CAMPAIGNS):
            first, second = np.exp(generator.normal(0.0, 0.5, (2, 60)))
            _, low, high = paired.mean_ratio(first, second, generator, resamples=399)
            held += low < 1.0 < high
        # Bootstrap intervals of 60 instances are a little short: 95 % within 2 % and the binomial error.
        assert abs(held / CAMPAIGNS - 0.95) < 0.02 + binomial_error(0.95)

    def test_a_planted_effect_is_found_with_its_power(self):
        # Wilcoxon's test of normal differences is as good as the mean's with 3 / pi of the instances.
        instances, effect, spread = 60, 0.25, 0.5
        generator = np.random.default_rng(12)
        found = 0
        for _ in range(CAMPAIGNS):
            first, second = simulated_times(generator, 2, instances, effect, spread)
            found += paired.time_probability(first, second) < 0.05
        shift = effect / (spread * math.sqrt(2.0)) * math.sqrt(instances * 3.0 / math.pi)
        power = stats.norm.sf(stats.norm.ppf(0.975) - shift)
        assert 0.7 < power < 0.8
        assert abs(found / CAMPAIGNS - power) < 0.02 + binomial_error(power)


class TestReport:
    """`infer.py` on a small campaign: what it prints is what the estimators say."""

    def printed(self, **changes):
        rows = []
        for instance in range(8):
            rows.append(("walls", instance, "ours", True, "solved", 0.001 * (1 + instance)))
            rows.append(("walls", instance, "fast", True, "solved", 0.0005 * (1 + instance) + 1e-5 * instance**2))
            rows.append(("walls", instance, "dead", False, "timeout", 1.0))
        columns = ["group", "experiment", "planner", "solved", "outcome", "cpu"]
        campaign = SimpleNamespace(runs=pandas.DataFrame(rows, columns=columns).assign(limit_s=1.0))
        options = {"planner": "ours", "against": [], "group": "", "level": 0.95, "seed": 1, **changes}
        return list(infer.report(campaign, SimpleNamespace(**options)))

    def test_tables(self):
        lines = self.printed()
        assert "| walls | dead | 0/8 | 0.0 to 32.4 | - | never (never to never) | 1000 (1000 to 1000) |" in lines
        assert any(line.startswith("| walls | ours | 8/8 | 67.6 to 100.0 |") for line in lines)
        # All of 8 solved here and none there: 2 / 2^8 by either exact test; Benjamini and Hochberg double the success test's,
        # the other one of which says nothing.
        alone = next(line for line in lines if line.startswith("| walls | dead | 8 |"))
        assert alone.startswith("| walls | dead | 8 | 8 : 0 | 0.0156 | 222 (")
        assert " | 0.00781 | " in alone
        assert lines == self.printed()

    def test_declared_comparisons_only(self):
        lines = self.printed(against=["dead"])
        assert sum(line.startswith("| walls | fast | 8 |") for line in lines) == 0
        assert next(line for line in lines if line.startswith("| walls | dead | 8 |")).startswith(
            "| walls | dead | 8 | 8 : 0 | 0.00781 |"
        )
