# Reference values of psychometric_fit_test.cpp, made once with R 4.2.2 (Debian 12: r-base-core,
# r-cran-psyphy 0.2-3-1):
#
#     Rscript psychometric_function.R
#
# writes psychometric_samples.csv (levels, trials, positive answers) and psychometric_expected.csv
# (what R says of them). Neither R nor its packages are needed to build or test mien.

suppressMessages(library(psyphy))
set.seed(20260214)
options(digits = 17)

samples <- list()
expected <- list()
sample_of <- function(name, d) {
  samples[[paste0(name, "/level")]] <<- d$level
  samples[[paste0(name, "/trials")]] <<- d$n
  samples[[paste0(name, "/positive")]] <<- d$k
}
expect <- function(name, ...) {
  values <- c(...)
  expected[[length(expected) + 1]] <<-
    data.frame(name = name, quantity = names(values), value = as.numeric(values))
}
simulated <- function(level, n, p)
  data.frame(level = level, n = n, k = rbinom(length(level), n, p))

# psyphy's cloglog link with m alternatives, and its others, by name. With guess 0: glm's own.
links <- function(shape, m) {
  if (m == 1) return(switch(shape, logistic = "logit", normal = "probit", weibull = "cloglog"))
  switch(shape, logistic = mafc.logit(m), normal = mafc.probit(m), weibull = mafc.cloglog(m))
}
fitted_by <- function(link, d, ...) suppressWarnings(
  glm(cbind(k, n - k) ~ level, binomial(link), d,
      control = list(epsilon = 1e-15, maxit = 500), ...))
saturated <- function(d) sum(dbinom(d$k, d$n, d$k / d$n, log = TRUE))
choose_sum <- function(d) sum(lchoose(d$n, d$k))
numbers_of <- function(fit, d) {
  b <- unname(coef(fit))
  c(location = -b[1] / b[2], width = 1 / b[2], deviance = deviance(fit),
    log_likelihood = saturated(d) - choose_sum(d) - deviance(fit) / 2)
}

# --- Fixed rates: glm, and psyphy for alternatives ----------------------------------------------

shapes <- c("logistic", "normal", "weibull")
f <- list(logistic = plogis, normal = pnorm, weibull = function(z) 1 - exp(-exp(z)))
for (shape in shapes) for (m in c(1, 2, 4)) {
  name <- paste(shape, m, sep = "/")
  guess <- if (m == 1) 0 else 1 / m
  level <- seq(-3, 4, length.out = 8)
  d <- simulated(level, c(40, 25, 30, 60, 35, 40, 50, 20),
                 guess + (1 - guess) * f[[shape]]((level - 0.4) / 1.1))
  sample_of(name, d)
  expect(name, guess = guess, numbers_of(fitted_by(links(shape, m), d), d))
}

# Letters by eccentricity (Yssaad-Fesselier and Knoblauch 2006), four alternatives, of psyphy:
# levels are logarithms of the contrast.
data(ecc2)
for (task in levels(ecc2$task)) for (size in unique(ecc2$Size)) {
  part <- ecc2[ecc2$task == task & ecc2$Size == size, ]
  d <- data.frame(level = log10(part$Contr), n = part$Correct + part$Incorrect, k = part$Correct)
  name <- paste("letters", task, size, sep = "/")
  sample_of(name, d)
  fit <- fitted_by(mafc.weib(4), d)
  expect(name, guess = 0.25, numbers_of(fit, d),
         threshold = unname((log(-log(1 - (0.625 - 0.25) / 0.75)) - coef(fit)[1]) / coef(fit)[2]))
}

# --- An estimated lapse rate: the profile over psyphy's probit.lambda ----------------------------

for (m in c(2, 3)) {
  name <- paste("lapse", m, sep = "/")
  level <- seq(-2, 5, length.out = 9)
  d <- simulated(level, 80, 1 / m + (1 - 1 / m - 0.03) * pnorm((level - 0.8) / 0.9))
  sample_of(name, d)
  profile <- function(lapse) deviance(fitted_by(probit.lambda(m, lapse), d))
  lapse <- optimize(profile, c(0, 0.06), tol = 1e-10)$minimum
  expect(name, guess = 1 / m, lapse = lapse, numbers_of(fitted_by(probit.lambda(m, lapse), d), d))
}
d <- data.frame(level = 0:5, n = 50, k = c(26, 27, 34, 44, 50, 50))
sample_of("no-lapse", d)
expect("no-lapse", guess = 0.5, lapse = 0, numbers_of(fitted_by(probit.lambda(2, 0), d), d))
d <- data.frame(level = 0:6, n = 50, k = c(26, 29, 36, 43, 45, 44, 45))
sample_of("bounded-lapse", d)
expect("bounded-lapse", guess = 0.5, lapse = 0.06,
       numbers_of(fitted_by(probit.lambda(2, 0.06), d), d))

# --- Both rates estimated: the profile over psyphy's logit.2asym ---------------------------------

level <- seq(-5, 5, length.out = 11)
d <- simulated(level, 120, 0.12 + (1 - 0.12 - 0.04) * plogis((level - 0.3) / 0.7))
sample_of("yes-no", d)
profile <- function(p) deviance(fitted_by(logit.2asym(p[1], p[2]), d))
best <- optim(c(0.1, 0.03), profile, method = "L-BFGS-B", lower = c(1e-4, 1e-4),
              upper = c(0.5, 0.06),
              control = list(factr = 10, pgtol = 0, ndeps = c(1e-5, 1e-5)))$par
best <- optim(best, profile, control = list(reltol = 1e-15, maxit = 5000))$par
expect("yes-no", guess = best[1], lapse = best[2],
       numbers_of(fitted_by(logit.2asym(best[1], best[2]), d), d))

# --- Written ------------------------------------------------------------------------------------

long <- do.call(rbind, lapply(names(samples), function(name)
  data.frame(sample = name, value = samples[[name]])))
number <- function(x) sprintf("%.17g", x)
writeLines(c("sample,value", paste(long$sample, number(long$value), sep = ",")),
           "psychometric_samples.csv")
all <- do.call(rbind, expected)
writeLines(c("name,quantity,value", paste(all$name, all$quantity, number(all$value), sep = ",")),
           "psychometric_expected.csv")
