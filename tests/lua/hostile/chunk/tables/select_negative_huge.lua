-- tries to index arguments far out of range
-- expect: error
return select(-1e9, 1)
