-- Fails on purpose.
error("no such luck")
