-- tries to keep a count that nobody hashes
-- expect: error
count = (count or 0) + 1
