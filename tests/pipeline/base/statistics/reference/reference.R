# Reference values of the statistics, made once with R 4.2.2 (Debian 12: r-base-core, r-cran-psych,
# r-cran-coin, r-cran-afex 1.2-1, r-cran-emmeans 1.8.4-1, r-cran-lmertest 3.1-3):
#
#     Rscript reference.R
#
# writes samples.csv (the numbers that are tested) and expected.csv (what R says of them). Neither
# R nor its packages are needed to build or test mien.

set.seed(20240518)
options(digits = 17)

samples <- list()
expected <- list()
sample_of <- function(name, values) {
  samples[[name]] <<- values
  invisible(values)
}
expect <- function(name, ...) {
  values <- c(...)
  expected[[length(expected) + 1]] <<-
    data.frame(name = name, quantity = names(values), value = as.numeric(values))
}

# --- Signed ranks -------------------------------------------------------------------------------

signed_ranks <- function(d, zeros) {
  considered <- if (zeros == "wilcox") d[d != 0] else d
  r <- rank(abs(considered))
  list(d = considered, r = r)
}

exact_p <- function(ranks, signs) {  # conditional on the ranks, by counting
  doubled <- round(2 * ranks)
  counts <- 1
  for (k in doubled) {
    shifted <- c(rep(0, k), counts)
    counts <- c(counts, rep(0, k)) / 2 + shifted / 2
  }
  w <- sum(doubled[signs > 0]) + 1
  min(1, 2 * min(sum(counts[1:w]), sum(counts[w:length(counts)])))
}

signed_rank_expectations <- function(name, d) {
  for (zeros in c("wilcox", "pratt", "zsplit")) {
    s <- signed_ranks(d, zeros)
    nonzero <- s$d != 0
    plus <- sum(s$r[s$d > 0])
    minus <- sum(s$r[s$d < 0])
    rest <- if (zeros == "zsplit") sum(s$r[!nonzero]) else 0
    spread <- sqrt(sum((if (zeros == "zsplit") s$r else s$r[nonzero])^2) / 4)
    departure <- (plus - minus) / 2
    z <- departure / spread
    zc <- (departure - sign(departure) * 0.5) / spread
    expect(paste0(name, "/", zeros), v = plus + rest / 2, used = sum(nonzero),
           zeros = sum(d == 0), p_normal = 2 * pnorm(-abs(z)), z = z,
           p_corrected = 2 * pnorm(-abs(zc)),
           p_exact = exact_p(s$r[nonzero], s$d[nonzero]),
           rank_biserial = (plus - minus) / (plus + minus))
  }
  # The same by functions of R, where it has them.
  r <- suppressWarnings(wilcox.test(d, exact = FALSE, correct = TRUE))
  n <- suppressWarnings(wilcox.test(d, exact = FALSE, correct = FALSE))
  coin_p <- function(method, distribution) {
    paired <- data.frame(x = d, y = 0 * d)
    as.numeric(coin::pvalue(coin::wilcoxsign_test(x ~ y, data = paired, zero.method = method,
                                                  distribution = distribution)))
  }
  expect(paste0(name, "/wilcox"), v = unname(r$statistic), p_corrected = r$p.value,
         p_normal = n$p.value)
  expect(paste0(name, "/wilcox"), p_normal = coin_p("Wilcoxon", "asymptotic"),
         p_exact = coin_p("Wilcoxon", "exact"))
  expect(paste0(name, "/pratt"), p_normal = coin_p("Pratt", "asymptotic"),
         p_exact = coin_p("Pratt", "exact"))
  walsh <- outer(d, d, "+")
  walsh <- sort(walsh[!lower.tri(walsh)]) / 2
  for (level in c(0.9, 0.95, 0.99)) {
    alpha <- 1 - level
    qu <- qsignrank(alpha / 2, length(d))
    if (qu == 0) qu <- 1
    ql <- length(walsh) - qu
    expect(paste0(name, "/hodges-lehmann-", level), estimate = median(walsh), low = walsh[qu],
           high = walsh[ql + 1])
  }
}

signed_rank_expectations("ratings", sample_of("ratings", sample(-4:4, 31, TRUE)))
signed_rank_expectations("few", sample_of("few", c(1, -2, 0, 3, 3, 0, 1)))
signed_rank_expectations("halves", sample_of("halves", round(2 * rnorm(60, 0.4, 1.5)) / 2))
smooth <- sample_of("smooth", rnorm(24, 0.3))
signed_rank_expectations("smooth", smooth)
for (level in c(0.9, 0.95, 0.99)) {
  r <- wilcox.test(smooth, exact = TRUE, conf.int = TRUE, conf.level = level)
  expect(paste0("smooth/hodges-lehmann-", level), estimate = unname(r$estimate),
         low = r$conf.int[1], high = r$conf.int[2])
  expect("smooth/wilcox", p_exact = r$p.value, v = unname(r$statistic))
}

# --- t tests, effect sizes, correlation -----------------------------------------------------------

a <- sample_of("a", rnorm(23, 1.1, 0.8))
b <- sample_of("b", rnorm(23, 0.7, 1.6))
c_ <- sample_of("c", rnorm(17, 0.2, 1.1))
for (level in c(0.9, 0.95)) {
  r <- t.test(a - b, conf.level = level)
  expect(paste0("paired-", level), t = unname(r$statistic), degrees = unname(r$parameter),
         p = r$p.value, mean = unname(r$estimate), low = r$conf.int[1], high = r$conf.int[2])
  r <- t.test(a, c_, conf.level = level)
  expect(paste0("welch-", level), t = unname(r$statistic), degrees = unname(r$parameter),
         p = r$p.value, low = r$conf.int[1], high = r$conf.int[2])
  r <- cor.test(a, b, conf.level = level)
  expect(paste0("pearson-", level), r = unname(r$estimate), t = unname(r$statistic), p = r$p.value,
         low = r$conf.int[1], high = r$conf.int[2])
}
pooled <- sqrt((22 * var(a) + 16 * var(c_)) / 38)
j <- function(df) exp(lgamma(df / 2) - lgamma((df - 1) / 2)) / sqrt(df / 2)
expect("effect", d = (mean(a) - mean(c_)) / pooled, g = j(38) * (mean(a) - mean(c_)) / pooled,
       dz = mean(a - b) / sd(a - b), gz = j(22) * mean(a - b) / sd(a - b))

# --- Means ----------------------------------------------------------------------------------------

for (name in c("ratings", "few", "smooth")) {
  x <- samples[[name]]
  r <- t.test(x)
  expect(paste0(name, "/summary"), mean = mean(x), sd = sd(x), median = median(x),
         low = r$conf.int[1], high = r$conf.int[2])
}

# --- Corrections ----------------------------------------------------------------------------------

p <- sample_of("p-values", c(0.04, 0.001, 0.9, 0.012, 0.012, 0.3, 0.0499, 1, 0.00002, 0.02))
expect("holm", setNames(p.adjust(p, "holm"), seq_along(p)))
expect("benjamini-hochberg", setNames(p.adjust(p, "BH"), seq_along(p)))

# --- Shares ---------------------------------------------------------------------------------------

for (k in list(c(0, 10, 0.2), c(10, 10, 0.5), c(7, 40, 1 / 6), c(23, 40, 0.5), c(1, 3, 0.25),
               c(81, 263, 0.25), c(30, 300, 1 / 7))) {
  name <- paste(k[1], "of", k[2])
  r <- suppressWarnings(prop.test(k[1], k[2], correct = FALSE))
  expect(name, low = r$conf.int[1], high = r$conf.int[2], chance = k[3],
         p = binom.test(k[1], k[2], k[3])$p.value)
}

# --- Agreement ------------------------------------------------------------------------------------

shrout_fleiss <- matrix(c(9, 2, 5, 8, 6, 1, 3, 2, 8, 4, 6, 8, 7, 1, 2, 6, 10, 5, 6, 9, 6, 2, 4, 7),
                        6, 4, byrow = TRUE)
icc_expectations <- function(name, m) {
  sample_of(name, as.vector(t(m)))
  r <- psych::ICC(m, lmer = FALSE)$results$ICC
  expect(name, one = r[1], two = r[2], three = r[3], one_k = r[4], two_k = r[5], three_k = r[6],
         alpha = unname(unlist(suppressWarnings(psych::alpha(m, warnings = FALSE))$total[1])),
         rows = nrow(m), columns = ncol(m))
}
icc_expectations("shrout-fleiss", shrout_fleiss)
icc_expectations("scale", matrix(pmax(-2, pmin(2, round(rep(rnorm(12), 9) + rnorm(108, 0.2)))), 12, 9))

# With missing cells: analyses of variance by lm, after each other.
icc_of_a_part <- function(name, m) {
  sample_of(name, as.vector(t(m)))
  d <- data.frame(y = as.vector(m), s = factor(row(m)), r = factor(col(m)))
  d <- d[!is.na(d$y), ]
  rss <- function(f) sum(resid(lm(f, d))^2)
  both <- rss(y ~ s + r); after_r <- rss(y ~ r); after_s <- rss(y ~ s)
  N <- nrow(d); n <- nlevels(d$s); k <- nlevels(d$r)
  k0 <- (N - sum(table(d$s)^2) / N) / (n - 1)
  msw <- after_s / (N - n)
  msb <- (rss(y ~ 1) - after_s) / (n - 1)
  e <- both / (N - n - k + 1)
  vs <- (after_r - both - (n - 1) * e) / (N - k)
  vr <- (after_s - both - (k - 1) * e) / (N - n)
  expect(name, one = (msb - msw) / (msb + (k0 - 1) * msw), one_k = (msb - msw) / msb,
         two = vs / (vs + vr + e), two_k = vs / (vs + (vr + e) / k0), three = vs / (vs + e),
         three_k = vs / (vs + e / k0), rows = nrow(m), columns = ncol(m))
}
part <- matrix(round(rep(rnorm(10), 14) + rep(rnorm(14, 0, 0.5), each = 10) + rnorm(140)), 10, 14)
part[cbind(rep(1:10, 5), sample(14, 50, TRUE))] <- NA
icc_of_a_part("part", part)

# --- Analysis of variance ---------------------------------------------------------------------------

root_of <- function(f, from, to) uniroot(f, c(from, to), tol = 1e-13)$root
partial_eta_interval <- function(f, df1, df2, level = 0.9) {
  lambda <- function(below) {
    if (pf(f, df1, df2) <= below) return(0)
    root_of(function(l) pf(f, df1, df2, ncp = l) - below, 0, 100 + 10 * df1 * f)
  }
  l <- c(lambda((1 + level) / 2), lambda((1 - level) / 2))
  l / (l + df1 + df2 + 1)
}
dz_interval <- function(t, n, level = 0.95) {
  delta <- function(below) root_of(function(d) pt(t, n - 1, ncp = d) - below, t - 15, t + 15)
  c(delta((1 + level) / 2), delta((1 - level) / 2)) / sqrt(n)
}

# `m`: a row for each participant, a column for each cell, the last factor varying fastest. By afex,
# which takes type III sums of squares and Greenhouse and Geisser's epsilon from car.
anova_expectations <- function(name, m, levels, group = NULL) {
  sample_of(name, as.vector(t(m)))
  sample_of(paste0(name, "/levels"), levels)
  sample_of(paste0(name, "/groups"), if (is.null(group)) rep(0, nrow(m)) else group)
  factors <- LETTERS[seq_along(levels)]
  cells <- expand.grid(lapply(rev(levels), seq_len))[rev(seq_along(levels))]
  names(cells) <- factors
  d <- do.call(rbind, lapply(seq_len(nrow(m)), function(i) cbind(cells, id = i, y = m[i, ])))
  d$id <- factor(d$id)
  for (f in factors) d[[f]] <- factor(d[[f]])
  if (!is.null(group)) d$G <- factor(group[as.integer(d$id)])
  fit <- function(es, ...) suppressMessages(afex::aov_ez(
    "id", "y", d, within = factors, between = if (is.null(group)) NULL else "G",
    observed = if (is.null(group)) NULL else "G", anova_table = list(es = es, ...)))
  ges <- fit("ges", correction = "none")
  raw <- ges$anova_table
  corrected <- fit("pes", correction = "GG")$anova_table
  univariate <- suppressWarnings(summary(ges$Anova)$univariate.tests)
  expect(name, rows = nrow(m), columns = ncol(m))
  for (effect in rownames(raw)) {
    epsilon <- corrected[effect, "num Df"] / raw[effect, "num Df"]
    interval <- partial_eta_interval(raw[effect, "F"], corrected[effect, "num Df"],
                                     corrected[effect, "den Df"])
    expect(paste(name, effect, sep = "/"), f = raw[effect, "F"], degrees = raw[effect, "num Df"],
           error_degrees = raw[effect, "den Df"], p = raw[effect, "Pr(>F)"], epsilon = epsilon,
           p_corrected = corrected[effect, "Pr(>F)"], partial_eta = corrected[effect, "pes"],
           generalized_eta = raw[effect, "ges"], low = interval[1], high = interval[2],
           squares = unname(univariate[effect, "Sum Sq"]),
           error_squares = unname(univariate[effect, "Error SS"]))
  }
  if (!is.null(group)) return(invisible())
  # Base R: the same F by error strata.
  formula <- reformulate(c(paste(factors, collapse = "*"),
                           sprintf("Error(id/(%s))", paste(factors, collapse = "*"))), "y")
  for (stratum in summary(aov(formula, d))) {
    table <- stratum[[1]]
    for (effect in setdiff(trimws(rownames(table)), "Residuals")) {
      row <- match(effect, trimws(rownames(table)))
      expect(paste(name, effect, sep = "/"), f = table[row, "F value"], p = table[row, "Pr(>F)"])
    }
  }
  # Cousineau and Morey, step by step.
  normed <- m - rowMeans(m) + mean(m)
  k <- ncol(m); n <- nrow(m)
  margins <- qt(0.975, n - 1) * sqrt(apply(normed, 2, var) * k / (k - 1)) / sqrt(n)
  expect(paste0(name, "/margins"), setNames(margins, seq_len(k)))
  # A contrast of levels of the first factor, by the multivariate model.
  weights <- if (levels[1] == 2) c(1, -1) else c(1, -0.5, -0.5, rep(0, levels[1] - 3))
  means <- emmeans::emmeans(ges, "A", model = "multivariate")
  found <- as.data.frame(emmeans::contrast(means, list(first = weights)))
  interval <- dz_interval(found$t.ratio, n)
  expect(paste0(name, "/contrast"), estimate = found$estimate, t = found$t.ratio,
         degrees = found$df, p = found$p.value, dz = found$t.ratio / sqrt(n), dz_low = interval[1],
         dz_high = interval[2])
}

anova_cells <- function(people, levels, deviations, effects, step = 0) {
  count <- prod(levels)
  m <- matrix(rnorm(people * count), people) %*% diag(rep_len(deviations, count)) +
    rnorm(people, 0, 0.8) + rep(rep_len(effects, count), each = people) +
    outer(rnorm(people, 0, 0.7), rep_len(c(1, -0.5, 0, 0.3, -0.8), count))
  if (step > 0) step * round(m / step) else m
}
anova_expectations("anova-3", anova_cells(12, 3, c(0.5, 1, 2), c(0, 0.4, 1)), 3)
anova_expectations("anova-2-3", anova_cells(15, c(2, 3), c(0.4, 0.9, 1.6), c(0, 0.5, 0.9, 0.2), 0.5),
                   c(2, 3))
anova_expectations("anova-3-2-4", anova_cells(14, c(3, 2, 4), c(0.3, 1.2, 0.7, 2, 0.5),
                                              c(0, 0.6, -0.2, 0.1, 0.3)), c(3, 2, 4))
anova_expectations("anova-2-2-2-2", anova_cells(9, c(2, 2, 2, 2), c(0.5, 1.5, 0.8),
                                                c(0, 1, 0.2)), c(2, 2, 2, 2))
anova_expectations("anova-groups", anova_cells(21, c(2, 3), c(0.5, 1.4, 0.8), c(0, 0.3, 0.8)) +
                     rep(c(0, 0.4, 1), c(7, 9, 5)), c(2, 3), rep(0:2, c(7, 9, 5)))
anova_expectations("anova-two-groups", anova_cells(19, 4, c(0.5, 1.4, 0.8, 1), c(0, 0.3, 0.8)) +
                     rep(c(0, 0.7), c(6, 13)) %o% c(1, 0, 0.5, 2), 4, rep(0:1, c(6, 13)))

for (k in list(c(0.2, 2, 30), c(1.7, 1.4, 22.6), c(4, 3, 57), c(60, 1, 19), c(250, 6, 120)))
  expect(paste("partial eta", k[1], k[2], k[3]), setNames(partial_eta_interval(k[1], k[2], k[3]),
                                                          c("low", "high")))
for (k in list(c(0, 10), c(2.1, 24), c(-3.7, 8), c(11, 40)))
  expect(paste("dz", k[1], k[2]), setNames(dz_interval(k[1], k[2]), c("low", "high")))

# --- Participants and stimuli as crossed random effects -------------------------------------------

# `m`: a row for each participant, a column for each stimulus; stimuli of a cell are neighbours, the
# last factor varies fastest. By lmerTest: restricted maximum likelihood, Satterthwaite's degrees of
# freedom, type III. `slopes`: "A" for a random slope of A, without one for its intercept's.
crossed_expectations <- function(name, m, levels, per_cell, slopes = FALSE) {
  sample_of(name, as.vector(t(m)))
  sample_of(paste0(name, "/levels"), levels)
  factors <- LETTERS[seq_along(levels)]
  cells <- expand.grid(lapply(rev(levels), seq_len))[rev(seq_along(levels))]
  names(cells) <- factors
  cell <- rep(seq_len(nrow(cells)), each = per_cell)
  d <- data.frame(id = factor(rep(seq_len(nrow(m)), ncol(m))),
                  stimulus = factor(rep(seq_len(ncol(m)), each = nrow(m))), y = as.vector(m))
  for (f in factors) d[[f]] <- factor(cells[[f]][cell[as.integer(d$stimulus)]])
  random <- if (slopes) "(1 + A | id)" else "(1 | id)"
  formula <- as.formula(paste("y ~", paste(factors, collapse = "*"), "+", random, "+ (1 | stimulus)"))
  fit <- suppressMessages(lmerTest::lmer(
    formula, d, contrasts = setNames(rep(list("contr.sum"), length(factors)), factors),
    control = lme4::lmerControl(optimizer = "bobyqa", optCtrl = list(rhoend = 1e-10),
                                check.conv.singular = "ignore", calc.derivs = FALSE)))
  table <- anova(fit, type = 3, ddf = "Satterthwaite")
  expect(name, rows = nrow(m), columns = ncol(m), per_cell = per_cell)
  for (effect in rownames(table))
    expect(paste(name, effect, sep = "/"), f = signif(table[effect, "F value"], 6),
           degrees = table[effect, "NumDF"], error_degrees = signif(table[effect, "DenDF"], 6),
           p = signif(table[effect, "Pr(>F)"], 6))  # iterated: further digits vary
}

crossed_ratings <- function(people, cells, per_cell, participant, stimulus, cell_of_person, effects) {
  columns <- cells * per_cell
  cell <- rep(seq_len(cells), each = per_cell)
  matrix(rnorm(people, 0, participant), people, columns) +
    matrix(rep(rnorm(columns, 0, stimulus), each = people), people, columns) +
    matrix(rnorm(people * cells, 0, cell_of_person), people)[, cell] +
    matrix(rep(effects[cell], each = people), people, columns) + matrix(rnorm(people * columns), people)
}
crossed_expectations("crossed-2-3", crossed_ratings(14, 6, 4, 0.7, 0.6, 0, (1:6) / 4), c(2, 3), 4)
crossed_expectations("crossed-2", crossed_ratings(16, 2, 6, 0.7, 0.5, 0.6, c(0, 0.7)), 2, 6)
crossed_expectations("crossed-slopes", crossed_ratings(16, 2, 6, 0.7, 0.5, 0.6, c(0, 0.7)), 2, 6, TRUE)
# Without differences between stimuli, some estimates of their variance are 0.
m <- crossed_ratings(10, 3, 3, 0.5, 0, 0, c(0, 0.2, 0.1))
means <- colMeans(m)
m <- m - rep(means - ave(means, rep(1:3, each = 3)), each = 10) * 0.9  # hardly any within cells
crossed_expectations("crossed-none", m, 3, 3)

# --- Consistency of paired comparisons --------------------------------------------------------------

# `wins`: a row and a column for each stimulus; wins[i, k]: how often i was chosen over k. Definitions
# only, triad by triad: no formula of Kendall and Babington Smith.
triads_of <- function(n) combn(n, 3, simplify = FALSE)
orders_of <- function(triad) list(triad, triad[c(1, 3, 2)], triad[c(2, 1, 3)], triad[c(2, 3, 1)],
                                  triad[c(3, 1, 2)], triad[c(3, 2, 1)])
is_circular <- function(wins, t)
  (wins[t[1], t[2]] && wins[t[2], t[3]] && wins[t[3], t[1]]) ||
  (wins[t[2], t[1]] && wins[t[3], t[2]] && wins[t[1], t[3]])
count_circular <- function(preferred) sum(sapply(triads_of(nrow(preferred)), function(t)
  is_circular(preferred, t)))
# The most circular triads: of a rotational tournament, in which each stimulus beats the next ones
# (Kendall and Babington Smith 1940: 1, 2, 5, 8, 14, 20 of 3 … 8 stimuli).
rotational <- function(n) outer(seq_len(n), seq_len(n), function(i, k) {
  ahead <- (k - i) %% n
  (ahead >= 1 & ahead < n / 2) | (ahead == n / 2 & i < k)
})
stopifnot(sapply(3:8, function(n) count_circular(rotational(n))) == c(1, 2, 5, 8, 14, 20))
consistency_expectations <- function(name, wins) {
  sample_of(name, as.vector(t(wins)))
  preferred <- wins > t(wins)
  circular <- count_circular(preferred)
  most <- count_circular(rotational(nrow(wins)))
  # Of random answers: a triad is circular in 2 of 8 cases.
  expect(name, stimuli = nrow(wins), circular = circular, most = most,
         by_chance = length(triads_of(nrow(wins))) * 2 / 8, zeta = 1 - circular / most)
}
consistency_expectations("six", matrix(c(0, 1, 1, 0, 1, 1,
                                         0, 0, 0, 1, 1, 0,
                                         0, 1, 0, 1, 1, 1,
                                         1, 0, 0, 0, 0, 0,
                                         0, 0, 0, 1, 0, 1,
                                         0, 1, 0, 1, 0, 0), 6, byrow = TRUE))
random_choices <- function(n, times, worth) {
  wins <- matrix(0, n, n)
  for (i in seq_len(n - 1)) for (k in (i + 1):n) {
    wins[i, k] <- rbinom(1, times, plogis(worth[i] - worth[k]))
    wins[k, i] <- times - wins[i, k]
  }
  wins
}
consistency_expectations("seven-odd", random_choices(7, 1, (1:7) / 3))
consistency_expectations("eight-majorities", random_choices(8, 5, (1:8) / 8))

# Stochastic transitivity, by all orders of each triad; `ties` count half for either.
transitivity_expectations <- function(name, wins, ties) {
  sample_of(name, as.vector(t(wins)))
  sample_of(paste0(name, "/ties"), as.vector(t(ties)))
  all <- wins + ties / 2
  share <- all / (all + t(all))
  broken <- sapply(triads_of(nrow(wins)), function(triad) min(sapply(orders_of(triad), function(o) {
    ab <- share[o[1], o[2]]; bc <- share[o[2], o[3]]; ac <- share[o[1], o[3]]
    if (ab < 0.5 || bc < 0.5) return(3)
    if (ac < 0.5) 3 else if (ac < min(ab, bc)) 2 else if (ac < max(ab, bc)) 1 else 0
  })))
  expect(name, stimuli = nrow(wins), triads = length(broken), weak = sum(broken >= 3),
         moderate = sum(broken >= 2), strong = sum(broken >= 1))
}
upper_ties <- function(n, p) {
  ties <- matrix(0, n, n)
  ties[upper.tri(ties)] <- rbinom(n * (n - 1) / 2, 3, p)
  ties + t(ties)
}
transitivity_expectations("shares", random_choices(8, 9, (1:8) / 4), matrix(0, 8, 8))
transitivity_expectations("shares-ties", random_choices(7, 8, (1:7) / 5), upper_ties(7, 0.4))

# Elo's ratings over all orders of seven comparisons: first, second, result of the first.
elo_games <- data.frame(first = c(1, 1, 2, 3, 1, 2, 4), second = c(2, 3, 3, 1, 4, 4, 3),
                        result = c(1, 1, 0, 1, 0.5, 1, 0))
sample_of("elo-games", as.vector(t(as.matrix(elo_games))))
permutations <- function(v) if (length(v) < 2) list(v) else
  do.call(c, lapply(seq_along(v), function(i) lapply(permutations(v[-i]), function(p) c(v[i], p))))
elo <- sapply(permutations(seq_len(nrow(elo_games))), function(order) {
  rating <- rep(1500, 4)
  for (g in order) {
    i <- elo_games$first[g]; k <- elo_games$second[g]
    gain <- 32 * (elo_games$result[g] - 1 / (1 + 10^((rating[k] - rating[i]) / 400)))
    rating[c(i, k)] <- rating[c(i, k)] + c(gain, -gain)
  }
  rating
})
expect("elo-games", setNames(rowMeans(elo), 1:4))
expect("elo-games/deviation", setNames(apply(elo, 1, function(r) sqrt(mean((r - mean(r))^2))), 1:4))

# Resampled participants: worths of four stimuli, by glm; expanded percentiles (Hesterberg 2015).
people <- 18
pairs_of_four <- t(combn(4, 2))
chosen <- t(sapply(seq_len(people), function(p) {
  own <- (4:1) / 2.5 + rnorm(4, 0, 0.5)
  rbinom(6, 3, plogis(own[pairs_of_four[, 1]] - own[pairs_of_four[, 2]]))
}))
sample_of("worth-people", as.vector(t(chosen)))
worths_of_counts <- function(k) {
  x <- matrix(0, 6, 4)
  x[cbind(1:6, pairs_of_four[, 1])] <- 1
  x[cbind(1:6, pairs_of_four[, 2])] <- -1
  total <- 3 * people
  b <- coef(glm.fit(x[, -4], cbind(k, total - k), family = binomial()))
  b <- c(b, 0)
  unname(b - mean(b))
}
worth <- worths_of_counts(colSums(chosen))
resampled <- replicate(4000, worths_of_counts(colSums(chosen[sample(people, replace = TRUE), ])))
tail <- pnorm(-sqrt(people / (people - 1)) * qt(0.975, people - 1))
ends <- apply(resampled, 1, quantile, c(tail, 1 - tail))
expect("worth-people", rows = people, columns = 6, setNames(worth, paste0("worth_", 1:4)),
       setNames(ends[1, ], paste0("low_", 1:4)), setNames(ends[2, ], paste0("high_", 1:4)),
       error = sd(resampled[1, ] - resampled[4, ]))

# --- Results of a study ------------------------------------------------------------------------------

# Ratings from -2 to 2 of stimuli with intended emotions on two scales: sad-happy, weak-strong.
intended <- c("sad", "happy", "weak", "strong", "sad")
rated <- expand.grid(stimulus = seq_along(intended), person = 1:9)
rated$first <- pmax(-2, pmin(2, round(c(-1, 1, 0, 0, -1)[rated$stimulus] + rnorm(nrow(rated)))))
rated$second <- pmax(-2, pmin(2, round(c(-0.5, 0, -1, 1, 0)[rated$stimulus] + rnorm(nrow(rated)))))
sample_of("rated", as.vector(t(as.matrix(rated))))
points <- with(rated, cbind(sad = pmax(0, -first), happy = pmax(0, first), weak = pmax(0, -second),
                            strong = pmax(0, second)))  # 2 points at an end, 1 half way
for (emotion in unique(intended)) {
  own <- points[intended[rated$stimulus] == emotion, , drop = FALSE]
  judged <- sum(rowSums(own) > 0)
  recall <- sum(own[, emotion]) / sum(own)
  hits <- sum(apply(own, 1, function(p) all(p[emotion] > p[names(p) != emotion])))
  decided <- sum(apply(own, 1, function(p) sum(p == max(p)) == 1))
  wilson <- prop.test(recall * judged, judged, correct = FALSE)$conf.int
  expect(paste0("confusion/", emotion), colSums(own), recall = recall, judged = judged, hits = hits,
         decided = decided, showings = nrow(own), low = wilson[1], high = wilson[2],
         p = binom.test(hits, decided, 1 / 4)$p.value)
}
for (pair in combn(4, 2, simplify = FALSE)) {
  r <- cor.test(points[, pair[1]], points[, pair[2]])
  expect(paste0("ends/", pair[1], "-", pair[2]), r = unname(r$estimate), p = r$p.value)
}
for (s in seq_along(intended)) {
  x <- rated$first[rated$stimulus == s]
  r <- t.test(x)
  expect(paste0("mean/", s), mean = mean(x), sd = sd(x), median = median(x), low = r$conf.int[1],
         high = r$conf.int[2])
}

# Two answers to the same question.
again <- data.frame(first = sample(-2:2, 40, TRUE))
again$second <- pmax(-2, pmin(2, again$first + sample(c(-1, 0, 0, 1), 40, TRUE)))
sample_of("again", as.vector(t(as.matrix(again))))
r <- cor.test(again$first, again$second)
expect("again", equal = sum(again$first == again$second), mean_difference =
         mean(abs(again$second - again$first)), r = unname(r$estimate), low = r$conf.int[1],
       high = r$conf.int[2])

# Sets of four of five stimuli: person, the stimuli, places (1 … 4) of the best and the worst.
sets <- do.call(rbind, lapply(1:10, function(p) t(sapply(1:5, function(left_out) {
  shown <- sample(setdiff(1:5, left_out))
  order <- order(shown + rnorm(4, 0, 1.5))
  c(p, shown, order[4], order[1])
}))))
sample_of("sets", as.vector(t(sets)))
for (s in 1:5) {
  score <- apply(sets, 1, function(row) {
    place <- match(s, row[2:5])
    if (is.na(place)) NA else (place == row[6]) - (place == row[7])
  })
  interval <- t.test(tapply(score, sets[, 1], mean, na.rm = TRUE))$conf.int
  expect(paste0("best-worst/", s), shown = sum(!is.na(score)), best = sum(score == 1, na.rm = TRUE),
         worst = sum(score == -1, na.rm = TRUE), score = mean(score, na.rm = TRUE),
         low = interval[1], high = interval[2])
}

# Detection: person, signal (1) or noise (0), answered with yes.
detected <- expand.grid(trial = 1:20, person = 1:8)
detected$signal <- as.numeric(detected$trial <= 10)
detected$yes <- rbinom(nrow(detected), 1, pnorm(detected$signal * (0.6 + detected$person / 8) - 0.5))
detected <- detected[, c("person", "signal", "yes")]
sample_of("detected", as.vector(t(as.matrix(detected))))
d_of <- function(d) {
  rate <- function(x) (sum(x) + 0.5) / (length(x) + 1)
  qnorm(rate(d$yes[d$signal == 1])) - qnorm(rate(d$yes[d$signal == 0]))
}
own <- sapply(split(detected, detected$person), d_of)
interval <- t.test(own)$conf.int
expect("detected", d = d_of(detected), mean = mean(own), low = interval[1], high = interval[2],
       correct = (mean(detected$yes[detected$signal == 1]) +
                  mean(1 - detected$yes[detected$signal == 0])) / 2)

# Traces of continuous ratings: rows are times (each 0.1 s), columns participants; the last one did
# not move the marker. The lag of the analysis is 0.5 s, the lead 1 s.
trace_times <- seq(0, 4, 0.1)
traces <- sapply(1:6, function(person)
  round(pmin(100, pmax(0, 50 + 30 * (1 - exp(-pmax(0, trace_times - 0.5) / 1.2)) +
                            pmin(1, trace_times) * rnorm(1, 0, 8) + cumsum(rnorm(41, 0, 1.5)))), 1))
traces[, 6] <- 50
sample_of("traces", as.vector(t(traces)))
for (k in c(0, 7, 35)) {
  values <- traces[trace_times == trace_times[6 + k], ]
  interval <- t.test(values)$conf.int
  expect(paste0("traces/", k), mean = mean(values), sd = sd(values), low = interval[1],
         high = interval[2])
}
followed <- traces[16:41, ]
r <- psych::ICC(followed, lmer = FALSE)$results$ICC
sums <- rowSums(followed)
expect("traces/agreement", two = r[2], two_k = r[5],
       alpha = 6 / 5 * (1 - sum(apply(followed, 2, var)) / var(sums)))
means <- colMeans(followed)
interval <- t.test(means)$conf.int
expect("traces/means", mean = mean(means), low = interval[1], high = interval[2])

# --- Written --------------------------------------------------------------------------------------

long <- do.call(rbind, lapply(names(samples), function(name)
  data.frame(sample = name, value = samples[[name]])))
number <- function(x) ifelse(is.na(x), "NA", sprintf("%.17g", x))
writeLines(c("sample,value", paste(long$sample, number(long$value), sep = ",")), "samples.csv")
all <- do.call(rbind, expected)
writeLines(c("name,quantity,value", paste(all$name, all$quantity, number(all$value), sep = ",")),
           "expected.csv")
