//! Relations to zero: as contracts write them, as programs decide them, as signs.

use crate::field::Sign;
use crate::program::Order;
use closedform_project::domain::ComparisonOperator;

/// How a contract's comparison compares the difference of its sides with zero.
pub fn order_of(operator: ComparisonOperator) -> Order {
    match operator {
        ComparisonOperator::Less => Order::Less,
        ComparisonOperator::LessEqual => Order::LessOrEqual,
        ComparisonOperator::Greater => Order::Greater,
        ComparisonOperator::GreaterEqual => Order::GreaterOrEqual,
        ComparisonOperator::Equal => Order::Equal,
        ComparisonOperator::NotEqual => Order::NotEqual,
    }
}

/// The signs of which an order relation speaks.
pub fn sign_of(order: Order) -> Sign {
    match order {
        Order::Less => Sign::NEGATIVE,
        Order::LessOrEqual => Sign::NONPOSITIVE,
        Order::Greater => Sign::POSITIVE,
        Order::GreaterOrEqual => Sign::NONNEGATIVE,
        Order::Equal => Sign::ZERO,
        Order::NotEqual => Sign::NONZERO,
    }
}
