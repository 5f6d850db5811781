-- tries to give itself more instructions
-- expect: refused
__count = 1e9
while true do end
