# Reference values of bradley_terry_test.cpp, made once with R 4.2.2 and its packages BradleyTerry2
# 1.1.2 and psychotools 0.7.2 (Debian 12: r-base-core, r-cran-bradleyterry2, r-cran-psychotools):
#
#     Rscript bradley_terry.R
#
# prints the counts and what R says of them. Neither R nor its packages are needed to build or test
# mien.
#
# Citations between four statistical journals (Stigler 1994), the American League of 1987 with its
# home teams (Agresti 2002, table 10.11), and flavours with ties (Springall 1973).

suppressPackageStartupMessages({
  library(BradleyTerry2)
  library(psychotools)
})

say <- function(name, values) cat(name, ": ", paste(sprintf("%.9f", values), collapse = ", "), "\n",
                                  sep = "")

# `d` has first, second (1 … n), wins of the first, wins of the second, and ties. A log-linear model
# (Fienberg and Larntz 1976): a cell for each outcome of each pair, whose total is fixed by `pair`.
cells_of <- function(d, n) {
  one <- function(k, outcome) {
    row <- rep(0, n + 2)
    if (outcome == "first") row[d$first[k]] <- 1
    if (outcome == "second") row[d$second[k]] <- 1
    if (outcome == "tie") row[c(d$first[k], d$second[k])] <- 0.5
    row[n + 1] <- c(first = 0.5, second = -0.5, tie = 0)[outcome]
    row[n + 2] <- as.numeric(outcome == "tie")
    row
  }
  outcomes <- if (sum(d$ties) > 0) c("first", "second", "tie") else c("first", "second")
  grid <- expand.grid(outcome = outcomes, k = seq_len(nrow(d)), stringsAsFactors = FALSE)
  x <- t(mapply(one, grid$k, grid$outcome))
  count <- mapply(function(k, o) d[k, c(first = "wins", second = "losses", tie = "ties")[o]],
                  grid$k, grid$outcome)
  list(x = x, count = count, pair = factor(grid$k), n = n)
}

# Worths that sum to zero: columns 1 … n − 1, minus the last.
design_of <- function(cells, order, ties) {
  n <- cells$n
  x <- cells$x[, seq_len(n - 1), drop = FALSE] - cells$x[, n]
  cbind(x, if (order) cells$x[, n + 1], if (ties) cells$x[, n + 2])
}
fit_of <- function(cells, x, offset = 0)
  glm.fit(cbind(model.matrix(~ cells$pair), x), cells$count, family = poisson(),
          offset = rep(0, length(cells$count)) + offset, control = list(epsilon = 1e-14, maxit = 100))

# Σ count·log(probability of the outcome).
likelihood_of <- function(cells, fit) {
  total <- ave(fit$fitted.values, cells$pair, FUN = sum)
  sum(cells$count * log(fit$fitted.values / total))
}

# Both ends of the 95 % interval of the worth of `k` by the likelihood ratio.
profile_of <- function(cells, x, k, estimate, error, best) {
  n <- cells$n
  fixed <- function(t) {
    if (k < n) {
      offset <- t * x[, k]
      rest <- x[, -k, drop = FALSE]
    } else {  # the last one is −Σ of the others: the first one takes its place
      offset <- -t * x[, 1]
      rest <- x
      rest[, 2:(n - 1)] <- x[, 2:(n - 1)] - x[, 1]
      rest <- rest[, -1, drop = FALSE]
    }
    2 * (best - likelihood_of(cells, fit_of(cells, rest, offset))) - qchisq(0.95, 1)
  }
  end <- function(side)
    uniroot(fixed, sort(estimate + side * error * c(0.5, 6)), tol = 1e-11)$root
  c(end(-1), end(1))
}

report <- function(title, d, n, order) {
  ties <- sum(d$ties) > 0
  cells <- cells_of(d, n)
  x <- design_of(cells, order, ties)
  fit <- fit_of(cells, x)
  m <- n - 1
  pairs <- nlevels(cells$pair)
  full <- cbind(model.matrix(~ cells$pair), x)
  v <- solve(t(full) %*% (full * fit$fitted.values))
  keep <- pairs + seq_len(ncol(x))
  b <- unname(fit$coefficients[keep])
  v <- v[keep, keep]
  worth <- c(b[1:m], -sum(b[1:m]))
  error <- sqrt(c(diag(v)[1:m], sum(v[1:m, 1:m])))
  # Of λ1 − λ2 and of (λ1 + λ2)/2 − λn, which is (λ1 + λ2)/2 + λ1 + … + λm.
  contrasts <- rbind(c(1, -1, rep(0, m - 2)), c(0.5, 0.5, rep(0, m - 2)) + 1)
  contrast_errors <- sqrt(diag(contrasts %*% v[1:m, 1:m] %*% t(contrasts)))
  best <- likelihood_of(cells, fit)
  cat("\n== ", title, "\n", sep = "")
  say("worth", worth)
  say("error", error)
  say("errors of contrasts", contrast_errors)
  if (order) say("order, error", c(b[n], sqrt(v[n, n])))
  if (ties) say("tie, error", c(b[length(b)], sqrt(v[length(b), length(b)])))
  say("log-likelihood", best)
  ends <- sapply(seq_len(n), function(k) profile_of(cells, x, k, worth[k], error[k], best))
  say("low", ends[1, ])
  say("high", ends[2, ])
  rest <- x[, -seq_len(m), drop = FALSE]
  chi <- 2 * (best - likelihood_of(cells, fit_of(cells, rest)))
  cat(sprintf("equal worth: chi %.9f, df %d, p %.9g\n", chi, m, pchisq(chi, m, lower.tail = FALSE)))
  if (order) {
    chi <- 2 * (best - likelihood_of(cells, fit_of(cells, x[, -n, drop = FALSE])))
    cat(sprintf("order: chi %.9f, df 1, p %.9g\n", chi, pchisq(chi, 1, lower.tail = FALSE)))
  }
}

centred <- function(b) b - mean(b)

data(citations)
d <- countsToBinomial(citations)
d <- data.frame(first = as.integer(d$player1), second = as.integer(d$player2), wins = d$win1,
                losses = d$win2, ties = 0)
print(d)
report("citations", d, 4, FALSE)
say("BradleyTerry2", centred(c(0, coef(BTm(cbind(win1, win2), player1, player2,
                                           data = countsToBinomial(citations))))))

data(baseball)
d <- data.frame(first = as.integer(baseball$home.team), second = as.integer(baseball$away.team),
                wins = baseball$home.wins, losses = baseball$away.wins, ties = 0)
print(levels(baseball$home.team))
print(d)
report("baseball, home and away", d, 7, TRUE)
home <- baseball
home$home.team <- data.frame(team = home$home.team, at.home = 1)
home$away.team <- data.frame(team = home$away.team, at.home = 0)
b <- coef(BTm(cbind(home.wins, away.wins), home.team, away.team, ~ team + at.home, id = "team",
              data = home))
say("BradleyTerry2, worth", centred(c(0, b[-length(b)])))
say("BradleyTerry2, at home", b[length(b)])

data(springall)
d <- springall$contests
d <- data.frame(first = as.integer(d$col), second = as.integer(d$row), wins = d$win,
                losses = d$loss, ties = d$tie)
print(d)
report("springall, ties", d, 9, FALSE)
report("springall, ties, and the column as first", d, 9, TRUE)
# psychotools wants a row for each person: of each comparison, one who answers only that. Its pairs
# are 1:2, 1:3, 2:3, 1:4 …
outcomes <- unlist(mapply(function(w, l, t) c(rep(1, w), rep(-1, l), rep(0, t)), d$wins, d$losses,
                          d$ties, SIMPLIFY = FALSE))
one <- rep(seq_len(nrow(d)), d$wins + d$losses + d$ties)
wide <- matrix(NA, length(one), 36)
for (r in seq_along(one)) {
  i <- d$first[one[r]]
  j <- d$second[one[r]]
  column <- choose(max(i, j) - 1, 2) + min(i, j)
  wide[r, column] <- outcomes[r] * (if (i < j) 1 else -1)
}
m <- btmodel(paircomp(wide, labels = as.character(1:9)), undecided = TRUE)
say("psychotools, worth", centred(log(itempar(m, log = FALSE))))
say("psychotools, tie", coef(m)["(undecided)"])
