-- tries to take the sine of a number without a meaningful one
-- expect: error
return math.sin(1e300)
