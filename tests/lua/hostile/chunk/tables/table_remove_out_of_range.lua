-- tries to remove where nothing is
-- expect: error
table.remove({ 1, 2 }, 1e300)
