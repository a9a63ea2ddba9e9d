# Reference values of signal_detection_test.cpp, made once with base R 4.2.2:
#
#     Rscript signal_detection.R
#
# prints them. R is not needed to build or test mien.

options(digits = 12)

rates <- function(hits, signals, alarms, noises)
  c(h = (hits + 0.5) / (signals + 1), f = (alarms + 0.5) / (noises + 1))

# Gourevitch and Galanter (1967) by the delta method.
yes_no <- function(hits, signals, alarms, noises) {
  r <- rates(hits, signals, alarms, noises)
  z <- qnorm(r)
  se <- sqrt(sum(r * (1 - r) / (c(signals, noises) * dnorm(z)^2)))
  c(d = unname(z["h"] - z["f"]), se = se, c = -sum(z) / 2)
}

# The differencing model: P("different") for a difference of d.
different <- function(d, k) pnorm((d - k) / sqrt(2)) + pnorm((-d - k) / sqrt(2))

differencing_d <- function(h, f) {
  k <- -sqrt(2) * qnorm(f / 2)
  uniroot(function(d) different(d, k) - h, c(0, 20), tol = 1e-13)$root
}

profile_interval <- function(hits, signals, alarms, noises) {
  log_likelihood <- function(d, k) {
    h <- different(d, k); f <- different(0, k)
    (hits + 0.5) * log(h) + (signals - hits + 0.5) * log1p(-h) +
      (alarms + 0.5) * log(f) + (noises - alarms + 0.5) * log1p(-f)
  }
  profile <- function(d)
    optimize(function(k) log_likelihood(d, k), c(0.01, d + 6), maximum = TRUE, tol = 1e-10)$objective
  r <- rates(hits, signals, alarms, noises)
  best <- differencing_d(r["h"], r["f"])
  limit <- profile(best) - qchisq(0.95, 1) / 2
  low <- if (profile(0) >= limit) 0
         else uniroot(function(d) profile(d) - limit, c(0, best), tol = 1e-10)$root
  high <- uniroot(function(d) profile(d) - limit, c(best, best + 5), tol = 1e-10)$root
  c(d = best, low = low, high = high)
}

cat("yes_no(18, 20, 4, 20)\n"); print(yes_no(18, 20, 4, 20))
cat("yes_no(40, 40, 0, 30)\n"); print(yes_no(40, 40, 0, 30))
cat("differencing_d(0.642, 0.3)\n"); print(differencing_d(0.642, 0.3))
for (h in c(0.5, 0.7, 0.9)) for (f in c(0.1, 0.3))
  cat("differencing_d", h, f, differencing_d(h, f), "\n")
cat("same_different(30, 40, 12, 40)\n"); print(profile_interval(30, 40, 12, 40))
cat("same_different(13, 40, 12, 40)\n"); print(profile_interval(13, 40, 12, 40))
