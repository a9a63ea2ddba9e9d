# Reference values of planned_power_test.cpp, made once with R 4.2.2 and lmerTest 3.1-3 (Debian 12:
# r-base-core, r-cran-lmertest):
#
#     Rscript power.R
#
# prints the power of mixed models in simulated studies of two designs. R is not needed to build or
# test mien.

suppressPackageStartupMessages(library(lmerTest))

# Two cells of `per_cell` stimuli, seen by all participants; standard deviations in points.
study <- function(people, per_cell, participant, stimulus, residual, by_cell, difference) {
  columns <- 2 * per_cell
  cell <- rep(1:2, each = per_cell)
  y <- matrix(rnorm(people, 0, participant), people, columns) +
    matrix(rep(rnorm(columns, 0, stimulus), each = people), people) +
    matrix(rnorm(2 * people, 0, by_cell), people)[, cell] +
    matrix(rep(c(difference / 2, -difference / 2)[cell], each = people), people) +
    matrix(rnorm(people * columns, 0, residual), people)
  data.frame(y = as.vector(y), id = factor(rep(seq_len(people), columns)),
             stimulus = factor(rep(seq_len(columns), each = people)),
             A = factor(rep(cell, each = people)))
}

control <- lme4::lmerControl(check.conv.singular = "ignore", calc.derivs = FALSE)
power <- function(name, studies, formula, ...) {
  set.seed(20261129)
  one <- function() study(...)
  p <- replicate(studies, {
    d <- one()  # lmerTest evaluates the name again
    fit <- suppressMessages(lmer(formula, d, control = control,
                                 contrasts = list(A = "contr.sum")))
    anova(fit, type = 3, ddf = "Satterthwaite")["A", "Pr(>F)"]
  })
  share <- mean(p < 0.05)
  cat(sprintf("%s: %d of %d, %.4f (SE %.4f)\n", name, sum(p < 0.05), studies, share,
              sqrt(share * (1 - share) / studies)))
}

power("intercepts", 1000, y ~ A + (1 | id) + (1 | stimulus), 16, 6, 0.5, 0.5, 0.8, 0, 0.7)
power("slopes", 1000, y ~ A + (1 + A | id) + (1 | stimulus), 20, 8, 0.5, 0.4, 0.8, 0.5, 0.7)
