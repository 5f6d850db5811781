-- tries to walk over keys that have no order
-- expect: error
for k in pairs({ [{}] = 1, [{}] = 2 }) do end
