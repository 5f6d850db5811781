-- tries to get at an order that differs between runs
-- expect: error
for k in pairs({ [object] = 1 }) do end
