# Reference values of the statistics, made once with R 4.2.2 (Debian 12: r-base-core, r-cran-psych,
# r-cran-coin):
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
  values
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

# --- Written --------------------------------------------------------------------------------------

long <- do.call(rbind, lapply(names(samples), function(name)
  data.frame(sample = name, value = samples[[name]])))
number <- function(x) ifelse(is.na(x), "NA", sprintf("%.17g", x))
writeLines(c("sample,value", paste(long$sample, number(long$value), sep = ",")), "samples.csv")
all <- do.call(rbind, expected)
writeLines(c("name,quantity,value", paste(all$name, all$quantity, number(all$value), sep = ",")),
           "expected.csv")
