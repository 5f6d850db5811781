-- tries to keep a function for the next turn
-- expect: error
kept = out.addForce
